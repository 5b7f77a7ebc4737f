// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/room/room_state.h"

#include <algorithm>
#include <utility>

#include "roomcast/client/room/calibration_message.h"
#include "roomcast/wire/audio_header.h"
#include "roomcast/wire/frame_header.h"
#include "roomcast/wire/pose_message.h"

namespace roomcast::client {
namespace {

/// Whether the IDs of a message name this viewer or sensor.
template <class Id>
bool names(const google::protobuf::RepeatedField<std::uint32_t>& ids, Id id) {
  return std::ranges::find(ids, id.value) != ids.end();
}

}  // namespace

void RoomState::welcome(const wire::pb::Welcome& welcome) {
  room_.connected = true;
  room_.problem.clear();
  room_.room = welcome.room();
  room_.rights = {.may_record = welcome.may_record(),
                  .may_export = welcome.may_export(),
                  .may_speak = welcome.may_speak(),
                  .may_mark = welcome.may_mark(),
                  .may_place = welcome.may_place()};
  room_.self = ViewerId{welcome.viewer_id()};
  room_.clock.reset();
  room_.sensors_known = false;
  voices_.Clear();
  complete_set_ = {};
  for (RoomSensor& sensor : room_.sensors) sensor.is_paused = sensor.is_held_back = false;
  marks_.join(welcome.author_tag());
  room_.marks = marks_.all();
  ++room_.people_revision;
  if (auto pose = wire::read_transform(welcome.start_pose())) room_.start_pose = *pose;
  decoding_.clear();  // frames of an earlier connection are no base for new ones
}

void RoomState::disconnected(std::string problem) {
  room_.connected = false;
  room_.problem = std::move(problem);
  room_.people.clear();
  voices_.Clear();
  update_voices();
  ++room_.people_revision;
}

void RoomState::poses(const wire::pb::ViewerPoses& poses) {
  for (const auto& message : poses.poses()) {
    const auto person = std::ranges::find(room_.people, ViewerId{message.viewer_id()},
                                          [](const RoomPerson& p) { return p.id; });
    if (person != room_.people.end()) person->pose = pose_from_message(message);
  }
  ++room_.people_revision;
}

void RoomState::voices(const wire::pb::Voices& voices) {
  voices_ = voices;
  update_voices();
  ++room_.people_revision;
}

void RoomState::update_voices() {
  for (RoomPerson& person : room_.people) {
    person.speaking = names(voices_.speaking(), person.id);
    person.muted = names(voices_.muted(), person.id);
  }
  for (RoomSensor& sensor : room_.sensors) {
    sensor.speaking = names(voices_.speaking(), wire::speaker_of(sensor.id));
    sensor.muted = names(voices_.muted(), wire::speaker_of(sensor.id));
  }
}

void RoomState::unseen(const wire::pb::UnseenSensors& unseen) {
  for (RoomSensor& sensor : room_.sensors) {
    const bool is_paused = names(unseen.paused(), sensor.id);
    if (is_paused) sensor.is_paused = true;  // until its next frame
    sensor.is_held_back = names(unseen.held_back(), sensor.id);
    SensorDecoding& decoding = decoding_[sensor.id];
    decoding.has_gaps = is_paused || sensor.is_held_back || names(unseen.base_only(), sensor.id);
    decoding.newest_seq.reset();
  }
}

bool RoomState::set_ended(SetId set) {
  if (set <= complete_set_ || set > room_.newest_set) return false;
  complete_set_ = set;
  ++room_.sets_received;
  return true;
}

void RoomState::marks(const wire::pb::Marks& marks) {
  marks_.take(marks);
  room_.marks = marks_.all();
  if (!marks.refusal().empty()) {
    ++room_.mark_refusals;
    room_.mark_refusal = marks.refusal();
  }
  ++room_.people_revision;
}

/// People who stay in the room keep their last known pose.
void RoomState::update_people(const wire::pb::Roster& roster) {
  std::vector<RoomPerson> people;
  for (const auto& entry : roster.viewers()) {
    const std::uint32_t rgb = entry.color_rgb();
    RoomPerson person{ViewerId{entry.id()},
                      entry.name(),
                      {static_cast<std::uint8_t>(rgb >> 16U), static_cast<std::uint8_t>(rgb >> 8U),
                       static_cast<std::uint8_t>(rgb)},
                      {},
                      false,
                      false};
    const auto known =
        std::ranges::find(room_.people, person.id, [](const RoomPerson& p) { return p.id; });
    if (known != room_.people.end()) person.pose = known->pose;
    people.push_back(std::move(person));
  }
  room_.people = std::move(people);
  update_voices();
  ++room_.people_revision;
}

Status RoomState::roster(const wire::pb::Roster& roster) {
  update_people(roster);
  forget_others(roster);
  for (const auto& entry : roster.sensors()) {
    if (auto status = update_sensor(entry); !status) return status;
  }
  room_.sensors_known = true;
  update_voices();
  return {};
}

/// Removes the sensors that are no longer in the roster, also if another sensor has their ID by
/// now.
void RoomState::forget_others(const wire::pb::Roster& roster) {
  std::erase_if(room_.sensors, [&](const RoomSensor& known) {
    const bool is_listed = std::ranges::any_of(roster.sensors(), [&](const auto& entry) {
      return entry.id() == known.id.value && entry.name() == known.name;
    });
    if (!is_listed) decoding_.erase(known.id);
    return !is_listed;
  });
}

Status RoomState::update_sensor(const wire::pb::SensorEntry& entry) {
  auto calibration = calibration_from_message(entry.calibration());
  if (!calibration) return calibration.error();
  auto pose = wire::read_pose(entry);
  if (!pose) return pose.error();
  const SensorId id{static_cast<std::uint16_t>(entry.id())};
  auto known = std::find_if(room_.sensors.begin(), room_.sensors.end(),
                            [&](const RoomSensor& s) { return s.id == id; });
  if (known == room_.sensors.end()) {
    known = room_.sensors.emplace(known);
    known->id = id;
  }
  const bool another_grid = known->calibration.depth.width != calibration->depth.width ||
                            known->calibration.depth.height != calibration->depth.height;
  known->name = entry.name();
  known->online = entry.online();
  known->pose = *std::move(pose);
  known->fps = entry.fps();
  known->calibration = *calibration;
  if (another_grid) {
    known->picture.reset();
    decoding_.erase(id);
  }
  return {};
}

Result<RoomState::FrameOutcome> RoomState::frame(std::span<const std::uint8_t> message) {
  const auto header = wire::parse_frame(message);
  if (!header) return header.error();
  const auto sensor = std::find_if(room_.sensors.begin(), room_.sensors.end(),
                                   [&](const RoomSensor& s) { return s.id == header->sensor; });
  if (sensor == room_.sensors.end()) {
    return Error{ErrorCode::kMalformed, "a frame names a sensor that is not in the roster"};
  }
  const HostTime received = clock_.now();
  room_.bytes_received += message.size();
  sensor->bytes_received += message.size();
  SensorDecoding& decoding = decoding_[header->sensor];
  sensor->frames_missed += decoding.count_gap(*header);
  if (!decoding.chain.may_decode(*header)) {
    ++sensor->frames_missed;
    return FrameOutcome::kNeedsKey;
  }
  if (!decoding.decoder) {
    auto decoder = codec::FrameDecoder::create(sensor->calibration.depth.width,
                                               sensor->calibration.depth.height);
    if (!decoder) return decoder.error();
    decoding.decoder = std::move(*decoder);
  }
  auto picture = free_picture(decoding);
  if (auto status =
          decoding.decoder->decode(message.subspan(header->header_length), picture->frame);
      !status) {
    decoding.chain.broke();
    ++sensor->frames_missed;
    return FrameOutcome::kNeedsKey;
  }
  decoding.chain.decoded(*header);
  picture->seq = header->seq;
  picture->set = header->set;
  picture->capture_time = header->capture_time;
  picture->received = received;
  picture->decoded = clock_.now();
  ++sensor->frames_received;
  sensor->picture = std::move(picture);
  sensor->is_paused = false;
  sensor->is_small = header->small;
  room_.newest_set = std::max(room_.newest_set, header->set);
  if (!header->last) return FrameOutcome::kDecoded;
  complete_set_ = header->set;
  ++room_.sets_received;
  return FrameOutcome::kSetComplete;
}

/// The number of frames missed before this one. Sensors may start numbering anywhere, also after a
/// restart, and number each rendition by itself.
std::uint64_t RoomState::SensorDecoding::count_gap(const wire::FrameHeader& header) {
  const bool goes_on = newest_seq && is_small == header.small;
  const std::uint32_t step = goes_on ? header.seq - *newest_seq : 1;
  newest_seq = header.seq;
  is_small = header.small;
  if (has_gaps) return 0;
  return step > 0 && step <= kLongestGap ? step - 1 : 0;
}

std::shared_ptr<SensorPicture> RoomState::free_picture(SensorDecoding& decoding) {
  for (const auto& picture : decoding.pool) {
    if (picture.use_count() == 1) return picture;
  }
  return decoding.pool.emplace_back(std::make_shared<SensorPicture>());
}

std::shared_ptr<const RoomSnapshot> RoomState::snapshot() {
  ++room_.revision;
  return std::make_shared<const RoomSnapshot>(room_);
}

}  // namespace roomcast::client
