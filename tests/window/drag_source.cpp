#include "window/drag_source.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <memory>
#include <string_view>
#include <thread>

// Its names are many and common, so that no other header comes after it.
#include <X11/Xatom.h>
#include <X11/Xlib.h>

namespace mirrorball::testing {
namespace {

struct CloseDisplay {
  void operator()(::Display* display) const { XCloseDisplay(display); }
};

/// "file:///a%20name": all bytes but plain letters are written by their numbers.
std::string addressOf(const std::string& path) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string address = "file://";
  for (const char letter : path) {
    const auto byte = static_cast<unsigned char>(letter);
    const bool is_plain =
        byte < 128 && (std::isalnum(byte) != 0 || std::string_view("/-_.~").find(letter) != std::string_view::npos);
    address += is_plain ? std::string(1, letter) : std::string{'%', kDigits[byte / 16], kDigits[byte % 16]};
  }
  return address;
}

class DragSource {
 public:
  DragSource(const std::string& display, Window target, std::string addresses)
      : display_(XOpenDisplay(display.c_str())), target_(target), addresses_(std::move(addresses)) {
    if (!display_) return;
    own_ = XCreateSimpleWindow(display_.get(), DefaultRootWindow(display_.get()), 0, 0, 1, 1, 0, 0, 0);
    XSetSelectionOwner(display_.get(), atom("XdndSelection"), own_, CurrentTime);
  }

  bool isThere() const { return display_ != nullptr; }

  void enter() const { send("XdndEnter", {long(own_), 5L << 24, long(atom("text/uri-list")), 0, 0}); }
  void move(int x, int y) const {
    send("XdndPosition", {long(own_), 0, long(x) << 16 | y, CurrentTime, long(atom("XdndActionCopy"))});
  }
  void drop() const { send("XdndDrop", {long(own_), 0, CurrentTime, 0, 0}); }

  /// Gives what is asked for until the window says that.
  ///
  /// returns   whether it did, and accepts
  bool waitFor(const char* message) const {
    for (int tries = 0; tries < 500; ++tries) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      while (XPending(display_.get()) > 0) {
        XEvent event;
        XNextEvent(display_.get(), &event);
        if (event.type == SelectionRequest) give(event.xselectionrequest);
        if (event.type == ClientMessage && event.xclient.message_type == atom(message))
          return event.xclient.data.l[1] != 0;  // of XdndFinished GLFW has a number of bytes in place of the one bit
      }
    }
    return false;
  }

 private:
  Atom atom(const char* name) const { return XInternAtom(display_.get(), name, False); }

  void send(const char* message, const std::array<long, 5>& words) const {
    XEvent event = {};
    event.xclient.type = ClientMessage;
    event.xclient.window = target_;
    event.xclient.message_type = atom(message);
    event.xclient.format = 32;
    std::copy(words.begin(), words.end(), event.xclient.data.l);
    XSendEvent(display_.get(), target_, False, NoEventMask, &event);
    XFlush(display_.get());
  }

  void give(const XSelectionRequestEvent& asked) const {
    XChangeProperty(display_.get(), asked.requestor, asked.property, asked.target, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(addresses_.data()), static_cast<int>(addresses_.size()));
    XEvent event = {};
    event.xselection.type = SelectionNotify;
    event.xselection.requestor = asked.requestor;
    event.xselection.selection = asked.selection;
    event.xselection.target = asked.target;
    event.xselection.property = asked.property;
    event.xselection.time = asked.time;
    XSendEvent(display_.get(), asked.requestor, False, NoEventMask, &event);
    XFlush(display_.get());
  }

  std::unique_ptr<::Display, CloseDisplay> display_;
  Window target_;
  Window own_ = None;
  std::string addresses_;
};

}  // namespace

std::string dropFiles(const std::string& display, unsigned long window, const std::vector<std::string>& paths) {
  std::string addresses;
  for (const std::string& path : paths) addresses += addressOf(path) + "\r\n";
  const DragSource source(display, window, addresses);
  if (!source.isThere()) return "there is no display";
  source.enter();
  source.move(400, 300);
  if (!source.waitFor("XdndStatus")) return "it takes no files";
  source.drop();
  return source.waitFor("XdndFinished") ? "" : "it has not finished";
}

}  // namespace mirrorball::testing
