// SPDX-License-Identifier: Apache-2.0
#include <stop_token>

#include "bench/fanout/engine.h"
#include "bench/fanout/tls_identity.h"
#include "roomcast/hub/server/hub_server.h"

namespace roomcast::bench {

namespace {

class HubEngine final : public Engine {
 public:
  explicit HubEngine(bool tls) : tls_(tls) {}
  std::string name() const override { return tls_ ? "roomcast hub, TLS" : "roomcast hub"; }
  bool encrypts() const override { return tls_; }

  Result<RunningEngine> start(const FanoutRoom& room) const override {
    hub::HubOptions options;
    options.port = 0;
    // No sending limits: the benchmark measures the maximum speed.
    constexpr wire::SendingLimits kAnything{1e12, 1e12, 1e12, 1e12};
    options.limits.session = {kAnything, kAnything, kAnything, kAnything};
    options.rooms = {{.max_viewers = wire::kMaxViewers}};
    std::optional<net::Fingerprint> fingerprint;
    if (tls_) {
      auto identity = make_tls_identity();
      if (!identity) return identity.error();
      options.tls = identity->context;
      fingerprint = identity->fingerprint;
    }
    auto child = ChildProcess::fork_off([&](const ChildProcess::PortReport& report) {
      const auto server = hub::HubServer::open(options);
      if (!server) return;
      report((*server)->port());
      (*server)->run({});
    });
    if (!child) return child.error();
    return RunningEngine{*std::move(child), roomcast_protocol(room.fps), fingerprint};
  }

 private:
  bool tls_;
};

}  // namespace

std::unique_ptr<Engine> make_hub(bool tls) {
  return std::make_unique<HubEngine>(tls);
}

}  // namespace roomcast::bench
