// SPDX-License-Identifier: Apache-2.0
// roomcast doctor: says what works on this computer, and what to do about the rest.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "roomcast/cli/command.h"
#include "roomcast/cli/print.h"
#include "roomcast/cli/web_directory.h"
#include "roomcast/doctor/cameras.h"
#include "roomcast/doctor/computer.h"
#include "roomcast/doctor/hub_contact.h"
#include "roomcast/doctor/network.h"
#include "roomcast/doctor/pictures.h"
#include "roomcast/net/hub_url.h"

namespace roomcast::cli {
namespace {

using doctor::Finding;
using doctor::Verdict;

struct DoctorOptions {
  std::string hub;  // empty: none is contacted
  bool json = false;
};

Finding check_page() {
  if (const auto folder = find_web_directory(""))
    return {"page", Verdict::kOk, "A hub here serves the page in " + folder->string() + "."};
  return {"page", Verdict::kProblem, "The page for browsers is not installed.",
          "Build it with scripts/demo, or install the package roomcast."};
}

std::vector<Finding> examine(const DoctorOptions& options) {
  std::vector<Finding> findings = {doctor::check_processor(),
                                   doctor::check_memory(),
                                   doctor::check_descriptors(),
                                   doctor::check_clock(),
                                   doctor::check_disk(),
                                   doctor::check_addresses(),
                                   doctor::check_port(net::kDefaultPort),
                                   check_page(),
                                   doctor::check_browser(),
                                   doctor::check_graphics(),
                                   doctor::check_display(),
                                   doctor::check_headset()};
  std::ranges::move(doctor::check_cameras(), std::back_inserter(findings));
  if (!options.hub.empty()) findings.push_back(doctor::check_hub(options.hub));
  return findings;
}

long count(const std::vector<Finding>& findings, Verdict verdict) {
  return std::ranges::count(findings, verdict, &Finding::verdict);
}

void print_text(const std::vector<Finding>& findings) {
  for (const Finding& finding : findings) {
    print_out("{:<8} {:<12} {}\n", doctor::name_of(finding.verdict), finding.topic,
              finding.sentence);
    if (!finding.remedy.empty()) print_out("{:<8} {:<12} -> {}\n", "", "", finding.remedy);
  }
  print_out("\n{} problems, {} notices\n", count(findings, Verdict::kProblem),
            count(findings, Verdict::kNotice));
}

void print_json(const std::vector<Finding>& findings, const Status& status) {
  nlohmann::json error = nlohmann::json::object();
  add_error(status, error);
  nlohmann::ordered_json json(error);
  json["problems"] = count(findings, Verdict::kProblem);
  json["notices"] = count(findings, Verdict::kNotice);
  json["findings"] = nlohmann::ordered_json::array();
  for (const Finding& finding : findings) {
    json["findings"].push_back({{"topic", finding.topic},
                                {"verdict", doctor::name_of(finding.verdict)},
                                {"sentence", finding.sentence},
                                {"remedy", finding.remedy}});
  }
  print_out("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

Outcome run_doctor(const DoctorOptions& options) {
  if (!options.hub.empty()) {
    if (const auto hubs = net::parse_hub_urls(options.hub); !hubs) return hubs.error();
  }
  const std::vector<Finding> findings = examine(options);
  Status status;
  if (const long problems = count(findings, Verdict::kProblem); problems > 0)
    status = unavailable("problems were found: " + std::to_string(problems));
  options.json ? print_json(findings, status) : print_text(findings);
  return {status, true};
}

}  // namespace

void add_doctor_command(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<DoctorOptions>();
  CLI::App* command = app.add_subcommand(
      "doctor", "Say what works on this computer, and what to do about the rest");
  command->add_option("--hub", options->hub,
                      "Also contact this hub and measure the round trip: ws://HOST:PORT");
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "Ends with 1 if there is a problem.\n\nExample:\n  roomcast doctor --hub "
      "ws://192.168.1.5:7600");
  command->callback([options, &chosen] {
    chosen = [options] { return finish("doctor", run_doctor(*options)); };
  });
}

}  // namespace roomcast::cli
