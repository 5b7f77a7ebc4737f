// SPDX-License-Identifier: Apache-2.0
// BundleLink: receives the calibration bundles of a room's sensors. A hub sends them only to
// aligners, so BundleLink joins as one, which needs an admin token; it sends nothing. Threading:
// used on one io_context only.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "roomcast/client/credential.h"
#include "roomcast/client/hub_link.h"

namespace roomcast::recording {

class BundleLink final : private client::HubLinkEvents {
 public:
  using OnBundle = std::function<void(const wire::pb::CalibrationBundle&)>;

  BundleLink(boost::asio::io_context& io, std::vector<net::HubUrl> hubs, const std::string& room,
             const client::Credential& credential, OnBundle on_bundle)
      : on_bundle_(std::move(on_bundle)),
        link_(io, std::move(hubs), join_message(room, credential), *this) {
    link_.start();
  }
  ~BundleLink() override { link_.stop(); }

 private:
  static wire::pb::Join join_message(const std::string& room,
                                     const client::Credential& credential) {
    wire::pb::Join join;
    join.set_room(room);
    join.set_name("recorder");
    show(credential, join);
    join.mutable_aligner();
    return join;
  }

  void on_welcome(const wire::pb::Welcome&) override {}
  void on_control(const wire::pb::Control& message) override {
    if (message.has_calibration_bundle()) on_bundle_(message.calibration_bundle());
  }
  void on_frame(net::MessageBuffer) override {}
  net::FramedMessagePtr next_frame() override { return nullptr; }
  void on_clock(const client::ClockEstimate&) override {}
  void on_down(const Error&, bool) override {}

  OnBundle on_bundle_;
  client::HubLink link_;
};

}  // namespace roomcast::recording
