// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/qr_code.h"

#include <memory>

#include <qrencode.h>

namespace roomcast::cli {

namespace {

constexpr int kQuietZone = 2;  // modules around the code; phones need a margin to detect it

class Squares {
 public:
  explicit Squares(const QRcode& code) : code_(code) {}
  [[nodiscard]] int begin() const { return -kQuietZone; }
  [[nodiscard]] int end() const { return code_.width + kQuietZone; }
  [[nodiscard]] bool is_dark(int x, int y) const {
    if (x < 0 || y < 0 || x >= code_.width || y >= code_.width) return false;
    return (code_.data[y * code_.width + x] & 1) != 0;
  }

 private:
  const QRcode& code_;
};

/// The character for two modules, one above the other. Light modules are drawn.
const char* character(bool upper_dark, bool lower_dark) {
  if (upper_dark) return lower_dark ? " " : "▄";
  return lower_dark ? "▀" : "█";
}

}  // namespace

Result<std::string> qr_code_for_terminal(const std::string& text) {
  const std::unique_ptr<QRcode, decltype(&QRcode_free)> code(
      QRcode_encodeString(text.c_str(), 0, QR_ECLEVEL_L, QR_MODE_8, 1), &QRcode_free);
  if (code == nullptr) return Error{ErrorCode::kTooLarge, "this is too long for a QR code"};
  const Squares squares(*code);
  std::string drawn;
  for (int y = squares.begin(); y < squares.end(); y += 2) {
    drawn += "\033[97;40m";  // white on black
    for (int x = squares.begin(); x < squares.end(); ++x) {
      drawn += character(squares.is_dark(x, y), squares.is_dark(x, y + 1));
    }
    drawn += "\033[0m\n";
  }
  return drawn;
}

}  // namespace roomcast::cli
