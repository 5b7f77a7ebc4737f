// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/web_site.h"

#include <algorithm>
#include <cctype>

#include "roomcast/net/hub_url.h"

namespace roomcast::net {

namespace {

constexpr std::string_view kHttp = "http://", kHttps = "https://";

Error not_a_site(std::string_view text, std::string_view remedy) {
  return {ErrorCode::kInvalidArgument,
          "\"" + std::string(text) + "\" is no web site; " + std::string(remedy)};
}

}  // namespace

Result<std::string> parse_web_site(std::string_view text) {
  std::string site(text);
  std::ranges::transform(site, site.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const bool is_https = site.starts_with(kHttps);
  if (!is_https && !site.starts_with(kHttp))
    return not_a_site(text, "write https://example.org, with https:// or http://");
  const std::string_view scheme = is_https ? kHttps : kHttp;
  const auto authority = std::string_view(site).substr(scheme.size());
  if (authority.find('*') != std::string_view::npos)
    return not_a_site(text, "name each site, as in https://example.org; \"*\" is none");
  if (authority.find_first_of("/#?") != std::string_view::npos)
    return not_a_site(text, "write https://example.org, without a path");
  if (authority.starts_with('['))
    return not_a_site(text, "browsers compare names here and no IPv6 addresses; write its name");
  if (!parse_hub_url(site)) return not_a_site(text, "write https://example.org");
  const std::string_view usual_port = is_https ? ":443" : ":80";
  if (site.ends_with(usual_port)) site.resize(site.size() - usual_port.size());
  return site;
}

}  // namespace roomcast::net
