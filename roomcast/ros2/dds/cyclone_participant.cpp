// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <utility>

#include <dds/dds.h>

#include "roomcast/ros2/dds/names.h"
#include "roomcast/ros2/dds/participant.h"
#include "roomcast/ros2/dds/serialised_type.h"

namespace roomcast::ros2 {
namespace {

/// Programs of this computer find each other without multicast, which its loopback may not have.
/// Its packets may be of 64 KiB: a picture is a tenth of the system calls that it is in a network.
constexpr const char* kOnlyLocalhost =
    "<CycloneDDS><Domain><General><Interfaces><NetworkInterface address='127.0.0.1'/></Interfaces>"
    "<AllowMulticast>false</AllowMulticast><MaxMessageSize>65000B</MaxMessageSize>"
    "<FragmentSize>63000B</FragmentSize></General><Discovery>"
    "<ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>32</MaxAutoParticipantIndex>"
    "<Peers><Peer address='127.0.0.1'/></Peers></Discovery></Domain></CycloneDDS>";

constexpr dds_duration_t kLongestBlocking = DDS_MSECS(100);  // of a reliable writer, as in ROS 2

Error failure(const std::string& what, dds_return_t code) {
  return unavailable(what + ": " + dds_strretcode(code));
}

/// An entity of DDS, deleted with all that belongs to it.
class Entity {
 public:
  explicit Entity(dds_entity_t id = 0) : id_(id) {}
  ~Entity() {
    if (id_ > 0) dds_delete(id_);
  }
  Entity(Entity&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  Entity& operator=(Entity&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  [[nodiscard]] dds_entity_t id() const { return id_; }

 private:
  dds_entity_t id_;
};

using Qos = std::unique_ptr<dds_qos_t, void (*)(dds_qos_t*)>;

Qos qos_of(const Quality& quality) {
  Qos qos(dds_create_qos(), dds_delete_qos);
  dds_qset_reliability(qos.get(),
                       quality.is_reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       kLongestBlocking);
  dds_qset_durability(
      qos.get(), quality.is_latched ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, quality.depth);
  if (quality.is_latched)
    dds_qset_durability_service(qos.get(), 0, DDS_HISTORY_KEEP_LAST, quality.depth,
                                DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
  return qos;
}

class CycloneWriter final : public Writer {
 public:
  CycloneWriter(Entity topic, Entity writer, const ddsi_sertype* type)
      : topic_(std::move(topic)), writer_(std::move(writer)), type_(type) {}

  [[nodiscard]] Status write(std::vector<std::uint8_t> message) override {
    if (message.size() > kMaxMessageBytes)
      return Error{ErrorCode::kTooLarge, "a message is larger than ROS 2 programs take"};
    ROOMCAST_ASSERT(message.size() >= 4 && message.size() % 4 == 0);
    ddsi_serdata* const sample =
        new_sample(*type_, std::make_shared<const std::vector<std::uint8_t>>(std::move(message)));
    const dds_return_t code = dds_writecdr(writer_.id(), sample);  // takes the reference
    if (code < 0) return failure("a message cannot be sent", code);
    return {};
  }

  [[nodiscard]] int reader_count() const override {
    dds_publication_matched_status_t status{};
    if (dds_get_publication_matched_status(writer_.id(), &status) < 0) return 0;
    return static_cast<int>(status.current_count);
  }

 private:
  Entity topic_, writer_;
  const ddsi_sertype* type_;  // lives as long as the topic
};

class CycloneReader final : public Reader {
 public:
  CycloneReader(Entity topic, Entity reader)
      : topic_(std::move(topic)), reader_(std::move(reader)) {}

  [[nodiscard]] Message take() override {
    for (;;) {
      ddsi_serdata* sample = nullptr;
      dds_sample_info_t info{};
      if (dds_takecdr(reader_.id(), &sample, 1, &info, DDS_ANY_STATE) < 1) return nullptr;
      Message message = info.valid_data ? message_of(*sample) : nullptr;
      ddsi_serdata_unref(sample);
      if (message) return message;  // else a writer has ended
    }
  }

 private:
  Entity topic_, reader_;
};

class CycloneParticipant final : public Participant {
 public:
  CycloneParticipant(Entity participant, Entity waiting)
      : participant_(std::move(participant)), waiting_(std::move(waiting)) {}

  [[nodiscard]] Result<std::unique_ptr<Writer>> writer(const Topic& topic) override {
    const ddsi_sertype* type = nullptr;
    auto entity = new_topic(topic, type);
    if (!entity) return entity.error();
    Entity writer(
        dds_create_writer(participant_.id(), entity->id(), qos_of(topic.quality).get(), nullptr));
    if (writer.id() < 0) return failure("cannot write " + topic.name, writer.id());
    return std::unique_ptr<Writer>(
        std::make_unique<CycloneWriter>(*std::move(entity), std::move(writer), type));
  }

  [[nodiscard]] Result<std::unique_ptr<Reader>> reader(const Topic& topic) override {
    const ddsi_sertype* type = nullptr;
    auto entity = new_topic(topic, type);
    if (!entity) return entity.error();
    Entity reader(
        dds_create_reader(participant_.id(), entity->id(), qos_of(topic.quality).get(), nullptr));
    if (reader.id() < 0) return failure("cannot read " + topic.name, reader.id());
    // Deleted with its reader.
    const dds_entity_t news = dds_create_readcondition(reader.id(), DDS_ANY_STATE);
    const dds_return_t code = news < 0 ? news : dds_waitset_attach(waiting_.id(), news, 0);
    if (code < 0) return failure("cannot read " + topic.name, code);
    return std::unique_ptr<Reader>(
        std::make_unique<CycloneReader>(*std::move(entity), std::move(reader)));
  }

  void wait(std::chrono::milliseconds patience) override {
    (void)dds_waitset_wait(waiting_.id(), nullptr, 0, DDS_MSECS(patience.count()));
  }

 private:
  [[nodiscard]] Result<Entity> new_topic(const Topic& topic, const ddsi_sertype*& type) {
    if (Status status = check_topic_name(topic.name); !status) return status.error();
    ddsi_sertype* new_type = new_serialised_type(dds_type_name(topic.type));
    Entity entity(dds_create_topic_sertype(participant_.id(), dds_topic_name(topic.name).c_str(),
                                           &new_type, nullptr, nullptr, nullptr));
    if (entity.id() < 0) {
      ddsi_sertype_unref(new_type);
      return failure("cannot open " + topic.name, entity.id());
    }
    type = new_type;
    return entity;
  }

  Entity participant_, waiting_;
};

void say_nothing(void*, const dds_log_data_t*) {}

/// Only once for each domain of a process; it holds until the process ends.
Status keep_to_localhost(int domain) {
  std::string settings = kOnlyLocalhost;
  if (const char* const more = std::getenv("CYCLONEDDS_URI"); more != nullptr && *more != 0)
    settings += "," + std::string(more);
  const dds_entity_t created =
      dds_create_domain(static_cast<dds_domainid_t>(domain), settings.c_str());
  if (created >= 0 || created == DDS_RETCODE_PRECONDITION_NOT_MET) return {};
  return failure("cannot open domain " + std::to_string(domain) + " of ROS 2", created);
}

}  // namespace

Result<std::unique_ptr<Participant>> Participant::open(const ParticipantOptions& options) {
  if (Status status = options.check(); !status) return status.error();
  // Cyclone writes lines of its own to stderr otherwise; what matters are the codes it returns.
  dds_set_log_sink(say_nothing, nullptr);
  dds_set_trace_sink(say_nothing, nullptr);
  if (options.only_localhost) {
    if (Status status = keep_to_localhost(options.domain); !status) return status.error();
  }
  Entity participant(
      dds_create_participant(static_cast<dds_domainid_t>(options.domain), nullptr, nullptr));
  if (participant.id() < 0)
    return failure("cannot join domain " + std::to_string(options.domain) + " of ROS 2",
                   participant.id());
  Entity waiting(dds_create_waitset(participant.id()));
  if (waiting.id() < 0) return failure("cannot wait for ROS 2", waiting.id());
  return std::unique_ptr<Participant>(
      std::make_unique<CycloneParticipant>(std::move(participant), std::move(waiting)));
}

}  // namespace roomcast::ros2
