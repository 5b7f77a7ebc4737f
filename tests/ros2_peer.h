// SPDX-License-Identifier: Apache-2.0
// For tests: a participant of Fast DDS on this computer, and topics with the names that ROS 2's
// layer over Fast DDS (rmw_fastrtps) gives them.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <fastcdr/FastBuffer.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>

#include "tests/ros2_peer_messages.h"

namespace ros2_peer {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

constexpr std::uint32_t kLargest = 1U << 20U;

/// A message as Fast DDS serialises it, by Fast CDR.
template <class Message>
class MessageType final : public dds::TopicDataType {
 public:
  MessageType() {
    setName(Message::kName);
    m_typeSize = kLargest;
    m_isGetKeyDefined = false;
  }
  bool serialize(void* data, rtps::SerializedPayload_t* payload) override {
    eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(payload->data), payload->max_size);
    eprosima::fastcdr::Cdr cdr(buffer, eprosima::fastcdr::Cdr::DEFAULT_ENDIAN,
                               eprosima::fastcdr::Cdr::DDS_CDR);
    payload->encapsulation = CDR_LE;
    cdr.serialize_encapsulation();
    Writing writing(cdr);
    static_cast<Message*>(data)->fields(writing);
    payload->length = static_cast<std::uint32_t>(cdr.getSerializedDataLength());
    return true;
  }
  bool deserialize(rtps::SerializedPayload_t* payload, void* data) override {
    eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(payload->data), payload->length);
    eprosima::fastcdr::Cdr cdr(buffer, eprosima::fastcdr::Cdr::DEFAULT_ENDIAN,
                               eprosima::fastcdr::Cdr::DDS_CDR);
    cdr.read_encapsulation();
    Reading reading(cdr);
    static_cast<Message*>(data)->fields(reading);
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void*) override {
    return [] { return kLargest; };
  }
  void* createData() override { return new Message; }
  void deleteData(void* data) override { delete static_cast<Message*>(data); }
  bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }
};

enum class Quality { kSensorData, kReliable, kStaticTransforms };

class Peer {
 public:
  explicit Peer(int domain) {
    dds::DomainParticipantQos qos;
    // This computer only, and without multicast, as ROS_LOCALHOST_ONLY asks for.
    auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
    udp->interfaceWhiteList.emplace_back("127.0.0.1");
    udp->receiveBufferSize = udp->sendBufferSize = 4U << 20U;
    qos.transport().use_builtin_transports = false;
    qos.transport().user_transports.push_back(udp);
    rtps::Locator_t peer;
    rtps::IPLocator::setIPv4(peer, "127.0.0.1");
    qos.wire_protocol().builtin.initialPeersList.push_back(peer);
    participant_ = dds::DomainParticipantFactory::get_instance()->create_participant(
        static_cast<dds::DomainId_t>(domain), qos);
    publisher_ = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
    subscriber_ = participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
  }

  template <class Message>
  dds::DataWriter* writer(const std::string& name, Quality quality) {
    dds::DataWriterQos qos;
    set(qos, quality);
    qos.endpoint().history_memory_policy = rtps::DYNAMIC_RESERVE_MEMORY_MODE;
    qos.publish_mode().kind = dds::SYNCHRONOUS_PUBLISH_MODE;
    return publisher_->create_datawriter(topic<Message>(name), qos);
  }

  template <class Message>
  dds::DataReader* reader(const std::string& name, Quality quality,
                          std::function<void(Message&)> take) {
    dds::DataReaderQos qos;
    set(qos, quality);
    qos.endpoint().history_memory_policy = rtps::DYNAMIC_RESERVE_MEMORY_MODE;
    return subscriber_->create_datareader(topic<Message>(name), qos,
                                          new Listener<Message>(std::move(take)));
  }

 private:
  template <class Message>
  struct Listener final : dds::DataReaderListener {
    explicit Listener(std::function<void(Message&)> do_take) : take(std::move(do_take)) {}
    void on_data_available(dds::DataReader* reader) override {
      Message message;
      dds::SampleInfo info;
      while (reader->take_next_sample(&message, &info) ==
             eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK) {
        if (info.valid_data) take(message);
      }
    }
    std::function<void(Message&)> take;
  };

  template <class Message>
  dds::Topic* topic(const std::string& name) {
    dds::TypeSupport type(new MessageType<Message>);
    type.register_type(participant_);
    return participant_->create_topic("rt" + name, type.get_type_name(), dds::TOPIC_QOS_DEFAULT);
  }

  template <class Qos>
  static void set(Qos& qos, Quality quality) {
    const bool is_static = quality == Quality::kStaticTransforms;
    qos.reliability().kind = quality == Quality::kSensorData ? dds::BEST_EFFORT_RELIABILITY_QOS
                                                             : dds::RELIABLE_RELIABILITY_QOS;
    qos.durability().kind =
        is_static ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
    qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
    qos.history().depth = is_static ? 1 : 5;
  }

  dds::DomainParticipant* participant_ = nullptr;  // until the program ends
  dds::Publisher* publisher_ = nullptr;
  dds::Subscriber* subscriber_ = nullptr;
};

}  // namespace ros2_peer
