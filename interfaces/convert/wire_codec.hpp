// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <typeindex>
#include <vector>

#include "interfaces/bus/bus.hpp"
#include "interfaces/convert/wire_error.hpp"

namespace enfilade::wire {

/// A message as it travels: four bytes of encapsulation (00 01 00 00), then plain CDR, little endian.
using WireBytes = std::vector<std::uint8_t>;

/// Brings the messages of one model type to the wire and back.
struct WireCodec {
  std::string_view wire_type;  ///< DDS type name, as the topic table gives it
  std::type_index model_type;
  std::type_index idl_type;
  WireBytes (*encode)(const void* message);
  /// Throws WireError where the bytes are no message of this type; never reads outside them.
  AnyMessage (*decode)(std::span<const std::uint8_t> bytes);
};

/// The codec of `topic`. Every topic of the table has one, or this file would not compile; std::logic_error
/// for any other.
const WireCodec& codec_of(const TopicInfo& topic);

/// `message` after a journey through the IDL type and CDR: the same value, a new object.
AnyMessage through_wire(const TopicInfo& topic, const AnyMessage& message);

}  // namespace enfilade::wire
