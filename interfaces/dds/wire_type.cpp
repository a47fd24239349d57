// SPDX-License-Identifier: Apache-2.0
#include "interfaces/dds/wire_type.hpp"

#include <cstring>

#include "interfaces/convert/wire_codec.hpp"

namespace enfilade {

namespace {

using eprosima::fastrtps::rtps::SerializedPayload_t;
using wire::WireBytes;

constexpr std::uint32_t kFirstGuessBytes = 512;  // buffers grow with the messages

}  // namespace

WireType::WireType(std::string_view name) {
  setName(std::string(name).c_str());
  m_typeSize = kFirstGuessBytes;
  m_isGetKeyDefined = false;
  auto_fill_type_object(false);
  auto_fill_type_information(false);
}

bool WireType::serialize(void* sample, SerializedPayload_t* payload) {
  const auto& bytes = *static_cast<const WireBytes*>(sample);
  if (bytes.size() > payload->max_size) return false;
  std::memcpy(payload->data, bytes.data(), bytes.size());
  payload->length = static_cast<std::uint32_t>(bytes.size());
  payload->encapsulation = CDR_LE;
  return true;
}

bool WireType::deserialize(SerializedPayload_t* payload, void* sample) {
  static_cast<WireBytes*>(sample)->assign(payload->data, payload->data + payload->length);
  return true;
}

std::function<std::uint32_t()> WireType::getSerializedSizeProvider(void* sample) {
  return [sample] { return static_cast<std::uint32_t>(static_cast<const WireBytes*>(sample)->size()); };
}

void* WireType::createData() { return new WireBytes; }

void WireType::deleteData(void* sample) { delete static_cast<WireBytes*>(sample); }

}  // namespace enfilade
