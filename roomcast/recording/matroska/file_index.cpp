// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/matroska/file_index.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <span>
#include <utility>

#include "roomcast/recording/matroska/element.h"

namespace roomcast::recording::matroska {
namespace {

// Element IDs of RFC 9559.
enum Id : std::uint32_t {
  kEbml = 0x1A45DFA3,
  kDocType = 0x4282,
  kSegment = 0x18538067,
  kInfo = 0x1549A966,
  kTimestampScale = 0x2AD7B1,
  kDateUtc = 0x4461,
  kWritingApp = 0x5741,
  kTracks = 0x1654AE6B,
  kTrackEntry = 0xAE,
  kTrackNumber = 0xD7,
  kTrackUid = 0x73C5,
  kTrackType = 0x83,
  kName = 0x536E,
  kCodecId = 0x86,
  kCodecPrivate = 0x63A2,
  kDefaultDuration = 0x23E383,
  kContentEncodings = 0x6D80,
  kVideo = 0xE0,
  kPixelWidth = 0xB0,
  kPixelHeight = 0xBA,
  kCluster = 0x1F43B675,
  kTimestamp = 0xE7,
  kSimpleBlock = 0xA3,
  kBlockGroup = 0xA0,
  kBlock = 0xA1,
  kAttachments = 0x1941A469,
  kAttachedFile = 0x61A7,
  kFileName = 0x466E,
  kFileData = 0x465C,
  kTags = 0x1254C367,
  kTag = 0x7373,
  kSimpleTag = 0x67C8,
  kTagName = 0x45A3,
  kTagString = 0x4487,
  kCues = 0x1C53BB6B,
  kSeekHead = 0x114D9B74,
  kChapters = 0x1043A770,
};

constexpr std::uint64_t kVideoTrack = 1;
constexpr std::uint64_t kDefaultTimestampScale_ns = 1'000'000;
constexpr std::uint64_t kMaxTimestampScale_ns = 1'000'000'000;
/// From 1970 to 2001, from where the format counts.
constexpr std::int64_t kEpoch_ns = 978'307'200LL * 1'000'000'000LL;
constexpr std::int64_t kMaxTime_ns = std::int64_t{1} << 60;
constexpr std::uint8_t kLacing = 0x06;
constexpr std::size_t kMaxBlockHeadBytes = 11;  // track, timestamp, flags

const Error kTooMany = {ErrorCode::kTooLarge, "it has too many elements"};

bool is_top_level(std::uint32_t id) {
  return id == kInfo || id == kTracks || id == kCluster || id == kAttachments || id == kTags ||
         id == kCues || id == kSeekHead || id == kChapters;
}

class Indexer {
 public:
  explicit Indexer(const ByteSource& source) : source_(source) {}

  Result<FileIndex> run() {
    const auto head = element_at(source_, 0, source_.size());
    if (!head || head->id != kEbml || head->end() > source_.size()) return not_matroska();
    std::string kind;
    if (Status status = children(*head, [&](const Element& e) { return text(e, kDocType, kind); });
        !status)
      return status.error();
    if (kind != "matroska" && kind != "webm") return not_matroska();
    const auto segment = element_at(source_, head->end(), source_.size());
    if (!segment || segment->id != kSegment) return not_matroska();
    if (Status status = read_segment(*segment); !status) return status.error();
    return std::move(index_);
  }

 private:
  using Visit = std::function<Status(const Element&)>;

  static Error not_matroska() { return malformed("it is not a Matroska file"); }

  /// Visits the elements in `parent`, all of which must be complete.
  Status children(const Element& parent, const Visit& visit) {
    for (std::uint64_t at = parent.content; at < parent.end();) {
      if (++elements_ > kMaxElements) return kTooMany;
      const auto element = element_at(source_, at, parent.end());
      if (!element || element->size > parent.end() - element->content)
        return malformed("an element of it is damaged");
      if (Status status = visit(*element); !status) return status;
      at = element->end();
    }
    return {};
  }

  Status text(const Element& element, Id id, std::string& into) {
    if (element.id != id) return {};
    auto read = text_of(source_, element);
    if (!read) return read.error();
    into = *std::move(read);
    return {};
  }
  Status number(const Element& element, Id id, std::uint64_t& into) {
    if (element.id != id) return {};
    const auto read = unsigned_of(source_, element);
    if (!read) return read.error();
    into = *read;
    return {};
  }

  Status read_segment(const Element& segment) {
    const bool cut = segment.size > source_.size() - segment.content;
    const std::uint64_t end = cut ? source_.size() : segment.end();
    for (std::uint64_t at = segment.content; at < end;) {
      if (++elements_ > kMaxElements) return kTooMany;
      const auto element = element_at(source_, at, end);
      if (!element) return end_early("an element of it is damaged");
      const bool is_open = element->id == kCluster && !element->has_size;
      if (!is_open && element->size > end - element->content && element->id != kCluster)
        return end_early("it ends too early");
      const auto next = read_top_level(*element, end);
      if (!next)
        return next.error().code == ErrorCode::kTooLarge ? Status(next.error())
                                                         : end_early(next.error().message);
      if (index_.damage) return {};
      at = *next;
    }
    if (cut && !index_.damage) return end_early("it ends too early");
    return {};
  }

  /// Damage after the first picture ends the reading; before it the file is refused.
  Status end_early(std::string why) {
    if (index_.blocks.empty()) return malformed(std::move(why));
    index_.damage = std::move(why);
    return {};
  }

  /// Returns where the next element begins.
  Result<std::uint64_t> read_top_level(const Element& element, std::uint64_t end) {
    Status status;
    if (element.id == kCluster) return read_cluster(element, end);
    if (element.id == kInfo)
      status = children(element, [&](const Element& e) { return read_info(e); });
    if (element.id == kTracks)
      status = children(element, [&](const Element& e) { return read_track(e); });
    if (element.id == kAttachments)
      status = children(element, [&](const Element& e) { return read_attachment(e); });
    if (element.id == kTags)
      status = children(element, [&](const Element& e) { return read_tag(e); });
    if (!status) return status.error();
    return element.end();
  }

  Status read_info(const Element& element) {
    if (element.id == kDateUtc) {
      const auto since_2001 = signed_of(source_, element);
      if (!since_2001) return since_2001.error();
      if (*since_2001 > 0 && *since_2001 < kMaxTime_ns)
        index_.began_utc = nanoseconds(*since_2001 + kEpoch_ns);
      return {};
    }
    if (Status status = number(element, kTimestampScale, scale_ns_); !status) return status;
    if (scale_ns_ == 0 || scale_ns_ > kMaxTimestampScale_ns)
      return malformed("its unit of time is invalid");
    return text(element, kWritingApp, index_.writing_program);
  }

  Status read_track(const Element& entry) {
    if (entry.id != kTrackEntry) return {};
    if (index_.tracks.size() == kMaxTracks) return kTooMany;
    Track track;
    std::uint64_t type = 0, period_ns = 0;
    const Status status = children(entry, [&](const Element& e) -> Status {
      if (e.id == kContentEncodings) track.is_encoded = true;
      if (e.id == kVideo) return children(e, [&](const Element& v) { return read_size(v, track); });
      if (e.id == kCodecPrivate) {
        auto bytes = bytes_of(source_, e, kMaxCodecPrivateBytes);
        if (!bytes) return bytes.error();
        track.codec_private = *std::move(bytes);
      }
      const std::pair<Id, std::uint64_t*> numbers[] = {{kTrackNumber, &track.number},
                                                       {kTrackUid, &track.uid},
                                                       {kTrackType, &type},
                                                       {kDefaultDuration, &period_ns}};
      for (const auto& [id, into] : numbers) {
        if (Status read = number(e, id, *into); !read) return read;
      }
      if (Status read = text(e, kName, track.name); !read) return read;
      return text(e, kCodecId, track.codec);
    });
    if (!status) return status;
    track.is_video = type == kVideoTrack;
    track.frame_period = nanoseconds(std::min<std::uint64_t>(period_ns, kMaxTime_ns));
    index_.tracks.push_back(std::move(track));
    return {};
  }

  Status read_size(const Element& element, Track& track) {
    if (Status status = number(element, kPixelWidth, track.width); !status) return status;
    return number(element, kPixelHeight, track.height);
  }

  Status read_attachment(const Element& file) {
    if (file.id != kAttachedFile) return {};
    if (index_.attachments.size() == kMaxAttachments) return kTooMany;
    Attachment attachment;
    const Status status = children(file, [&](const Element& e) -> Status {
      if (e.id == kFileData) {
        auto bytes = bytes_of(source_, e, kMaxAttachmentBytes);
        if (!bytes) return bytes.error();
        attachment.bytes = *std::move(bytes);
      }
      return text(e, kFileName, attachment.name);
    });
    if (!status) return status;
    attachment_bytes_ += attachment.bytes.size();
    if (attachment_bytes_ > 4 * kMaxAttachmentBytes) return kTooMany;
    index_.attachments.push_back(std::move(attachment));
    return {};
  }

  Status read_tag(const Element& tag) {
    if (tag.id != kTag) return {};
    return children(tag, [&](const Element& simple) -> Status {
      if (simple.id != kSimpleTag) return {};
      if (index_.tags.size() == kMaxTags) return kTooMany;
      std::string name, value;
      const Status status = children(simple, [&](const Element& e) -> Status {
        if (Status read = text(e, kTagName, name); !read) return read;
        return text(e, kTagString, value);
      });
      if (status && !name.empty()) index_.tags.emplace(std::move(name), std::move(value));
      return status;
    });
  }

  /// Returns the end of the cluster: stated, or that of its last element.
  Result<std::uint64_t> read_cluster(const Element& cluster, std::uint64_t segment_end) {
    const bool fits = cluster.size <= segment_end - cluster.content;
    const std::uint64_t end = fits ? cluster.end() : segment_end;
    std::uint64_t timestamp = 0;
    for (std::uint64_t at = cluster.content; at < end;) {
      if (++elements_ > kMaxElements) return kTooMany;
      const auto element = element_at(source_, at, end);
      if (!element) return malformed("an element of it is damaged");
      if (!cluster.has_size && is_top_level(element->id)) return at;
      if (element->size > end - element->content) return malformed("it ends too early");
      if (Status status = number(*element, kTimestamp, timestamp); !status) return status.error();
      Status status;
      if (element->id == kSimpleBlock) status = take_block(*element, timestamp);
      if (element->id == kBlockGroup) {
        status = children(*element, [&](const Element& e) {
          return e.id == kBlock ? take_block(e, timestamp) : Status();
        });
      }
      if (!status) return status.error();
      at = element->end();
    }
    return end;
  }

  Status take_block(const Element& element, std::uint64_t cluster_timestamp) {
    std::array<std::uint8_t, kMaxBlockHeadBytes> bytes{};
    const std::span<std::uint8_t> head(
        bytes.data(),
        static_cast<std::size_t>(std::min<std::uint64_t>(element.size, bytes.size())));
    if (Status status = source_.read(element.content, head); !status) return status;
    const auto number = read_variable_integer(head);
    if (!number || number->bytes + 3 > head.size()) return malformed("a block of it is damaged");
    const auto track = std::ranges::find(index_.tracks, number->value, &Track::number);
    if (track == index_.tracks.end() || !track->is_video) return {};
    const std::uint8_t* const rest = head.data() + number->bytes;
    if ((rest[2] & kLacing) != 0) return malformed("a block of it holds several pictures");
    const auto time = time_of(cluster_timestamp, static_cast<std::int16_t>(rest[0] << 8 | rest[1]));
    const std::uint64_t head_bytes = number->bytes + 3;
    if (!time || element.size - head_bytes > kMaxBlockBytes)
      return malformed("a block of it is damaged");
    if (index_.blocks.size() == kMaxBlocks) return kTooMany;
    index_.blocks.push_back({*time, element.content + head_bytes,
                             static_cast<std::uint32_t>(element.size - head_bytes),
                             static_cast<std::uint32_t>(track - index_.tracks.begin())});
    return {};
  }

  [[nodiscard]] std::optional<nanoseconds> time_of(std::uint64_t cluster,
                                                   std::int16_t block) const {
    const auto scale = static_cast<std::int64_t>(scale_ns_);
    if (cluster > static_cast<std::uint64_t>(kMaxTime_ns / scale)) return std::nullopt;
    return nanoseconds((static_cast<std::int64_t>(cluster) + block) * scale);
  }

  const ByteSource& source_;
  FileIndex index_;
  std::uint64_t scale_ns_ = kDefaultTimestampScale_ns;
  std::uint64_t elements_ = 0;
  std::size_t attachment_bytes_ = 0;
};

}  // namespace

Result<FileIndex> read_file_index(const ByteSource& source) {
  return Indexer(source).run();
}

}  // namespace roomcast::recording::matroska
