// SPDX-License-Identifier: Apache-2.0
// WebSocketConnection: one open WebSocket, after the handshake, server or client side.
//
// It alone writes to the socket: messages, pings, pongs and the close frame leave in one order,
// each complete. It has no queue of its own: when the socket can accept more, it requests the next
// message from its handler, so the handler decides at the last moment what to send. A peer that
// does not read costs no memory beyond the few messages being written.
//
// Threading: runs on the one thread of its io_context; all calls, and those to the handler, are
// made there. Source: RFC 6455; TCP_NOTSENT_LOWAT after "Prioritization Only Works When There's
// Pending Data to Prioritize".
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <boost/asio/steady_timer.hpp>

#include "roomcast/net/framed_message.h"
#include "roomcast/net/line_state.h"
#include "roomcast/net/outgoing_frames.h"
#include "roomcast/net/stream.h"
#include "roomcast/net/websocket_frame.h"
#include "roomcast/net/websocket_reader.h"

namespace roomcast::net {

/// The end of a connection. `code` is kAbnormal if it broke without a close frame from either side.
struct CloseReason {
  std::uint16_t code = close_code::kAbnormal;
  std::string sentence;
  bool by_peer = false;
};

/// Interface to the layer above.
class ConnectionHandler {
 public:
  virtual ~ConnectionHandler() = default;

  /// A whole message from the peer. Not called once close() or on_closed() has been called.
  virtual void on_message(MessageBuffer message) = 0;

  /// All messages of one read have been passed to on_message(); for handlers that process several
  /// at once. Called under the same conditions as on_message().
  virtual void on_read_done() {}

  /// The socket can accept more: returns the next message (framed without a mask), or null if there
  /// is none; then call wake() when there is. Not called once close() or on_closed() has been
  /// called; may be called from within wake().
  virtual FramedMessagePtr next_message() = 0;

  /// The connection has ended. Called once, never from within a call to the connection, and last.
  virtual void on_closed(const CloseReason& reason) = 0;
};

/// Silence is time in which the program listened and received nothing: time in which it did not run
/// (a busy or suspended machine) does not count.
struct ConnectionTimings {
  std::chrono::milliseconds ping_after{5'000};      // of silence from the peer
  std::chrono::milliseconds give_up_after{15'000};  // of silence from the peer
  std::chrono::milliseconds close_within{
      2'000};  // from close() to the end, whether the peer agreed or not
};

struct ConnectionOptions {
  WebSocketRole role = WebSocketRole::kServer;
  std::size_t max_message_bytes = 16 * 1024;
  ConnectionTimings timings = {};
  /// Kept as long as the socket is open, for counting open connections. May be null.
  std::shared_ptr<void> lease = {};
  /// Kept until settle(). May be null.
  std::shared_ptr<void> place = {};
};

struct ConnectionCounters {
  std::uint64_t bytes_in = 0;
  std::uint64_t bytes_out = 0;
  std::uint64_t messages_in = 0;
  std::uint64_t messages_out = 0;  // passed to the socket; the last ones may still be unsent
};

class WebSocketConnection : public std::enable_shared_from_this<WebSocketConnection> {
 public:
  /// `stream` is connected and the handshake is done; `received` are bytes that followed it in the
  /// same read.
  WebSocketConnection(Stream stream, ConnectionOptions options,
                      std::span<const std::uint8_t> received);
  WebSocketConnection(const WebSocketConnection&) = delete;
  WebSocketConnection& operator=(const WebSocketConnection&) = delete;

  /// Begins to read and write. Call once. The handler is released after on_closed().
  void start(std::shared_ptr<ConnectionHandler> handler);

  /// Call when next_message() has a message. It is called, and as much written as the socket
  /// accepts, before this returns: a hub with hundreds of viewers cannot afford an iteration of the
  /// event loop for each.
  void wake();

  /// Sends the messages already taken from the handler, then `last` if given, then a close frame,
  /// within ConnectionTimings::close_within. The reason is cut to kMaxCloseReason bytes. Only the
  /// first call counts; no effect on a connection that the peer has closed.
  void close(std::uint16_t code, std::string sentence);
  void close_after(FramedMessagePtr last, std::uint16_t code, std::string sentence);

  /// Marks the peer as legitimate: see HttpServerOptions::max_unsettled_per_peer.
  void settle() { options_.place.reset(); }

  /// Valid from now on.
  void set_timings(const ConnectionTimings& timings);
  /// Valid from the next frame on.
  void set_max_message_bytes(std::size_t bytes) { reader_.set_max_message_bytes(bytes); }

  /// "127.0.0.1:50312"
  [[nodiscard]] const std::string& peer_address() const { return peer_address_; }
  /// peer_name(), for counting and banning.
  [[nodiscard]] const std::string& peer() const { return peer_; }
  [[nodiscard]] const ConnectionCounters& counters() const { return counters_; }
  /// Bytes taken from the handler but not yet accepted by the kernel.
  [[nodiscard]] std::size_t unwritten_bytes() const { return outgoing_.unwritten_bytes(); }
  /// Bytes that this connection has not passed to the kernel count as unsent. Nothing once the
  /// socket is closed.
  [[nodiscard]] std::optional<LineState> line_state();
  /// As net::set_pace().
  void set_pace(double payload_bytes_per_s);
  /// True after close() was called, the peer closed, or the connection broke.
  [[nodiscard]] bool closing() const { return stage_ != Stage::kOpen; }

 private:
  using ErrorCode = boost::system::error_code;
  using SteadyTime = std::chrono::steady_clock::time_point;

  enum class Stage {
    kOpen,
    kClosing,    // our close frame is being sent; the peer's answer has not arrived
    kAnswering,  // nothing more will be read; our close frame is being sent
    kDraining,   // all is written; the peer has yet to end its side of the TCP connection
    kClosed,
  };

  void read();
  void on_read(ErrorCode error, std::size_t size);
  void take(std::span<const std::uint8_t> bytes);
  void take_event(NeedsMoreBytes) {}
  void take_event(MessageBuffer message);
  void take_event(Ping ping);
  void take_event(const Pong&) {}
  void take_event(const PeerClose& close);
  void take_event(Violation violation);

  void schedule_write();
  void write();
  bool refill();
  void pull();
  void on_wrote(std::size_t size, std::size_t offered);
  void wait_until_writable();
  void push_control(Opcode opcode, std::span<const std::uint8_t> payload);
  void push_message(FramedMessagePtr message);
  void push_close(std::uint16_t code, std::string_view reason);

  void watch_silence();
  void on_silence_timer();
  void bound_closing();
  void heard_from_peer();

  void on_write_failed();
  void on_all_written();
  void on_broken(ErrorCode error);
  void report(CloseReason reason);
  void shut(CloseReason reason);

  Stream stream_;
  boost::asio::steady_timer timer_;
  ConnectionOptions options_;
  std::string peer_address_;
  std::string peer_;
  std::shared_ptr<ConnectionHandler> handler_;
  ConnectionCounters counters_;
  Stage stage_ = Stage::kOpen;
  CloseReason reason_;  // of our own closing, reported at its end

  WebSocketReader reader_;
  std::vector<std::uint8_t> read_buffer_;
  std::size_t read_ahead_bytes_ = 0;
  std::vector<std::uint8_t> received_before_start_;
  SteadyTime last_heard_{};
  bool ping_sent_ = false;

  OutgoingFrames outgoing_;
  std::optional<Ping> unanswered_ping_;  // only the newest must be answered
  bool write_scheduled_ = false;
  bool pulling_ = false;  // next_message() is being called: its wake() has no effect
  bool write_failed_ = false;
  bool waiting_until_writable_ = false;
  bool handler_has_no_message_ =
      false;  // next_message() gave null, and wake() was not called since
  std::size_t pull_limit_bytes_;
};

}  // namespace roomcast::net
