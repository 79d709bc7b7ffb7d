/// The numbers that both sides agree on. To change one is to change the protocol: raise kProtocolVersion.
#pragma once

#include <cstddef>
#include <cstdint>

namespace ipc {

inline constexpr std::uint32_t kProtocolVersion = 10;

inline constexpr int kMaxClients = 32;                    ///< clients that command, per server
inline constexpr int kMaxKeys = 256;                      ///< key codes are 0..255
inline constexpr std::uint32_t kKeyRestraints = 2;        ///< levels of a client's keys, beside 0
inline constexpr std::size_t kMaxCommandText = 8192;      ///< bytes
inline constexpr std::size_t kCommandQueueLength = 32;    ///< commands under way, per client
inline constexpr std::size_t kReplyBytes = 65536;         ///< a client's reply area
inline constexpr std::size_t kMaxAnswerText = 65536 - 16; ///< bytes: the reply area less one record's header
inline constexpr std::uint32_t kMinFrameSlots = 3, kMaxFrameSlots = 8;
inline constexpr std::uint32_t kMaxFrameSide = 16384; ///< pixels

} // namespace ipc
