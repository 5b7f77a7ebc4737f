// SPDX-License-Identifier: Apache-2.0
#include "roomcast/ros2/dds/serialised_type.h"

#include <cstring>
#include <utility>

#include <dds/ddsi/q_radmin.h>

namespace roomcast::ros2 {
namespace {

constexpr std::size_t kDdsUnit = 4;

struct Sample : ddsi_serdata {
  Sample(const ddsi_sertype& its_type, ddsi_serdata_kind its_kind, Message its_message)
      : ddsi_serdata{}, message(std::move(its_message)) {
    ddsi_serdata_init(this, &its_type, its_kind);
  }
  Message message;
};

const Sample& sample_of(const ddsi_serdata* data) {
  return *static_cast<const Sample*>(data);
}

ddsi_serdata* empty_sample(const ddsi_sertype& type, ddsi_serdata_kind kind) {
  return new Sample(type, kind, std::make_shared<const std::vector<std::uint8_t>>(kDdsUnit));
}

bool same_key(const ddsi_serdata*, const ddsi_serdata*) {
  return true;  // without key there is one instance
}

std::uint32_t size_of(const ddsi_serdata* data) {
  return static_cast<std::uint32_t>(sample_of(data).message->size());
}

ddsi_serdata* from_fragments(const ddsi_sertype* type, ddsi_serdata_kind kind,
                             const nn_rdata* fragment, std::size_t size) {
  if (size < kDdsUnit || size > kMaxMessageBytes) return nullptr;
  auto message = std::make_shared<std::vector<std::uint8_t>>();
  message->reserve(size + kDdsUnit);
  for (; fragment != nullptr; fragment = fragment->nextfrag) {
    if (fragment->maxp1 <= message->size()) continue;  // nothing that is new
    const unsigned char* const payload =
        NN_RMSG_PAYLOADOFF(fragment->rmsg, NN_RDATA_PAYLOAD_OFF(fragment));
    message->insert(message->end(), payload + (message->size() - fragment->min),
                    payload + (fragment->maxp1 - fragment->min));
  }
  message->resize((size + kDdsUnit - 1) / kDdsUnit * kDdsUnit);
  return new Sample(*type, kind, std::move(message));
}

ddsi_serdata* from_pieces(const ddsi_sertype* type, ddsi_serdata_kind kind,
                          ddsrt_msg_iovlen_t count, const ddsrt_iovec_t* pieces, std::size_t size) {
  if (size < kDdsUnit || size > kMaxMessageBytes) return nullptr;
  auto message = std::make_shared<std::vector<std::uint8_t>>();
  message->reserve(size + kDdsUnit);
  for (ddsrt_msg_iovlen_t i = 0; i < count; ++i) {
    const auto* const begin = static_cast<const std::uint8_t*>(pieces[i].iov_base);
    message->insert(message->end(), begin, begin + pieces[i].iov_len);
  }
  message->resize((size + kDdsUnit - 1) / kDdsUnit * kDdsUnit);
  return new Sample(*type, kind, std::move(message));
}

ddsi_serdata* from_key_hash(const ddsi_sertype* type, const ddsi_keyhash*) {
  return empty_sample(*type, SDK_KEY);
}

/// Samples are made by new_sample(); Cyclone asks for one only where a writer ends.
ddsi_serdata* from_application(const ddsi_sertype* type, ddsi_serdata_kind kind, const void*) {
  return kind == SDK_KEY ? empty_sample(*type, kind) : nullptr;
}

void copy_to(const ddsi_serdata* data, std::size_t offset, std::size_t size, void* out) {
  std::memcpy(out, sample_of(data).message->data() + offset, size);
}

ddsi_serdata* refer_to(const ddsi_serdata* data, std::size_t offset, std::size_t size,
                       ddsrt_iovec_t* piece) {
  // The interface takes no pointers to const; Cyclone only reads.
  piece->iov_base = const_cast<std::uint8_t*>(sample_of(data).message->data()) + offset;
  piece->iov_len = static_cast<ddsrt_iov_len_t>(size);
  return ddsi_serdata_ref(data);
}

void refer_no_more(ddsi_serdata* data, const ddsrt_iovec_t*) {
  ddsi_serdata_unref(data);
}

bool to_application(const ddsi_serdata*, void*, void**, void*) {
  return false;  // readers take the serialised message
}

ddsi_serdata* without_type(const ddsi_serdata* data) {
  return empty_sample(*data->type, SDK_KEY);
}

bool to_application_without_type(const ddsi_sertype*, const ddsi_serdata*, void*, void**, void*) {
  return true;
}

void free_sample(ddsi_serdata* data) {
  delete static_cast<Sample*>(data);
}

std::size_t print(const ddsi_sertype*, const ddsi_serdata*, char* out, std::size_t size) {
  constexpr char kText[] = "(serialised)";
  const std::size_t count = std::min(size - 1, sizeof(kText) - 1);
  std::memcpy(out, kText, count);
  out[count] = 0;
  return count;
}

void key_hash(const ddsi_serdata*, ddsi_keyhash* hash, bool) {
  *hash = {};
}

constexpr ddsi_serdata_ops kSampleOperations = [] {
  ddsi_serdata_ops operations{};
  operations.eqkey = same_key;
  operations.get_size = size_of;
  operations.from_ser = from_fragments;
  operations.from_ser_iov = from_pieces;
  operations.from_keyhash = from_key_hash;
  operations.from_sample = from_application;
  operations.to_ser = copy_to;
  operations.to_ser_ref = refer_to;
  operations.to_ser_unref = refer_no_more;
  operations.to_sample = to_application;
  operations.to_untyped = without_type;
  operations.untyped_to_sample = to_application_without_type;
  operations.free = free_sample;
  operations.print = print;
  operations.get_keyhash = key_hash;
  return operations;
}();

void free_type(ddsi_sertype* type) {
  ddsi_sertype_fini(type);
  delete type;
}

bool same_type(const ddsi_sertype*, const ddsi_sertype*) {
  return true;  // Cyclone has compared the names
}

std::uint32_t no_hash(const ddsi_sertype*) {
  return 0;
}

void zero_samples(const ddsi_sertype*, void*, std::size_t) {}
void resize_samples(void** samples, const ddsi_sertype*, void*, std::size_t, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) samples[i] = nullptr;
}
void free_samples(const ddsi_sertype*, void**, std::size_t, dds_free_op_t) {}

std::size_t no_size(const ddsi_sertype*, const void*) {
  return 0;
}
bool not_written(const ddsi_sertype*, const void*, void*, std::size_t) {
  return false;
}

const ddsi_sertype_ops kTypeOperations = [] {
  ddsi_sertype_ops operations{};
  operations.version = ddsi_sertype_v0;
  operations.free = free_type;
  operations.zero_samples = zero_samples;
  operations.realloc_samples = resize_samples;
  operations.free_samples = free_samples;
  operations.equal = same_type;
  operations.hash = no_hash;
  operations.get_serialized_size = no_size;
  operations.serialize_into = not_written;
  return operations;
}();

}  // namespace

ddsi_sertype* new_serialised_type(const std::string& type_name) {
  auto* const type = new ddsi_sertype{};
  ddsi_sertype_init_flags(type, type_name.c_str(), &kTypeOperations, &kSampleOperations,
                          DDSI_SERTYPE_FLAG_TOPICKIND_NO_KEY);
  type->allowed_data_representation = DDS_DATA_REPRESENTATION_FLAG_XCDR1;
  return type;
}

ddsi_serdata* new_sample(const ddsi_sertype& type, Message message) {
  return new Sample(type, SDK_DATA, std::move(message));
}

Message message_of(const ddsi_serdata& sample) {
  return sample_of(&sample).message;
}

}  // namespace roomcast::ros2
