// SPDX-License-Identifier: Apache-2.0
#include "interfaces/convert/wire_codec.hpp"

#include <map>
#include <stdexcept>
#include <string>

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>

#include "interfaces/convert/metric_map.hpp"
#include "interfaces/convert/motion.hpp"
#include "interfaces/convert/requests.hpp"
#include "interfaces/convert/sensing.hpp"
#include "interfaces/topics/topics.hpp"

namespace enfilade::wire {

namespace {

using eprosima::fastcdr::Cdr;
using eprosima::fastcdr::FastBuffer;

constexpr std::size_t kEncapsulationBytes = 4;

template <class Model>
using IdlOf = decltype(to_wire(std::declval<const Model&>()));

template <class Model>
WireBytes encode(const void* message) {
  const auto idl = to_wire(*static_cast<const Model*>(message));
  WireBytes bytes(kEncapsulationBytes + IdlOf<Model>::getCdrSerializedSize(idl));
  FastBuffer buffer(reinterpret_cast<char*>(bytes.data()), bytes.size());
  Cdr cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR);
  cdr.serialize_encapsulation();
  idl.serialize(cdr);
  bytes.resize(cdr.getSerializedDataLength());
  return bytes;
}

template <class Model>
AnyMessage decode(std::span<const std::uint8_t> bytes) {
  check_count(bytes.size(), kMaxMessageBytes, "bytes of message");
  try {
    // Fast CDR reads through a pointer to non-const, and does not write.
    FastBuffer buffer(const_cast<char*>(reinterpret_cast<const char*>(bytes.data())), bytes.size());
    Cdr cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR);
    cdr.read_encapsulation();
    IdlOf<Model> idl;
    idl.deserialize(cdr);
    return std::make_shared<const Model>(from_wire(idl));
  } catch (const WireError&) {
    throw;
  } catch (const std::exception& error) {
    throw WireError(std::string("the bytes end too early or make no sense: ") + error.what());
  }
}

using CodecTable = std::map<std::string_view, WireCodec>;

CodecTable make_table() {
  CodecTable table;
  topics::for_each_topic([&table]<class Model>(const Topic<Model>& topic) {
    const WireCodec codec{topic.info.wire_type, typeid(Model), typeid(IdlOf<Model>), encode<Model>,
                          decode<Model>};
    table.emplace(codec.wire_type, codec);
  });
  return table;
}

}  // namespace

const WireCodec& codec_of(const TopicInfo& topic) {
  static const CodecTable table = make_table();
  const auto found = table.find(topic.wire_type);
  if (found == table.end()) throw std::logic_error("no codec for type " + std::string(topic.wire_type));
  return found->second;
}

AnyMessage through_wire(const TopicInfo& topic, const AnyMessage& message) {
  const WireCodec& codec = codec_of(topic);
  return codec.decode(codec.encode(message.get()));
}

}  // namespace enfilade::wire
