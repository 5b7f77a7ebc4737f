// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/bag_store.h"

#include <map>
#include <utility>

#include "roomcast/recording/rosbag/bag.h"

namespace roomcast::recording {
namespace {

class BagStore final : public RosStore {
 public:
  explicit BagStore(rosbag::Bag bag) : bag_(std::move(bag)) {
    std::map<std::uint32_t, std::uint32_t> topic_of;  // connections of one topic are one here
    std::map<std::string, std::uint32_t> known;
    for (const auto& [id, connection] : bag_.connections()) {
      const auto [found, is_new] =
          known.emplace(connection.topic, static_cast<std::uint32_t>(topics_.size()));
      if (is_new) topics_.push_back({connection.topic, connection.type});
      topic_of[id] = found->second;
    }
    messages_.reserve(bag_.messages().size());
    for (const rosbag::MessagePlace& place : bag_.messages())
      messages_.push_back({topic_of[place.connection], place.time});
  }

  [[nodiscard]] ros::Serialisation serialisation() const override {
    return ros::Serialisation::kRos1;
  }
  [[nodiscard]] const std::vector<StoredTopic>& topics() const override { return topics_; }
  [[nodiscard]] const std::vector<StoredMessage>& messages() const override { return messages_; }
  [[nodiscard]] Result<ros::ByteView> data(std::size_t message) override {
    return bag_.data(bag_.messages()[message]);
  }
  [[nodiscard]] std::optional<std::string> damage() const override { return bag_.damage(); }

 private:
  rosbag::Bag bag_;
  std::vector<StoredTopic> topics_;
  std::vector<StoredMessage> messages_;
};

}  // namespace

Result<std::shared_ptr<RosStore>> read_bag_store(std::unique_ptr<ByteSource> source) {
  auto bag = rosbag::Bag::read(std::move(source));
  if (!bag) return bag.error();
  return std::shared_ptr<RosStore>(std::make_shared<BagStore>(*std::move(bag)));
}

}  // namespace roomcast::recording
