#!/usr/bin/env python3
"""Breaks the bridge and its page, one rule at a time, and looks whether their quick tests notice. Builds in a copy of
the sources. A mutant that survives is an error: a rule that no test guards; so is one whose rule does not stand in the
sources any more.
  scripts/check_bridge_mutants.py [part of a name...]     without: all; with --list: their names;
                                                          with --check: only whether each rule stands in the sources
Mutants of the page need Chromium, and survive without."""
import os
import sys

import mutants

BRIDGE = "apps/bridge/"
SLOW = "-Floods.OfSlow*:BridgeSoak.*:Nginx.*:Requests.OfAny*"
PROGRAMS = [["test_bridge"], ["test_bridge_process", "--gtest_filter=" + SLOW], ["test_web_modules"]]
# The broken rule; then the file, the text that stands there, and its replacement.
MUTANTS = [
    ("frames: acknowledgements are ignored", [
        ("stream/rate_control.cpp", "if (found == flight_.end()) return false;",
         "return false;"),
    ]),
    ("frames: any number is on the way", [
        ("stream/rate_control.cpp", "return frames < std::min(window(), kMinWindow + drawn_);",
         "return frames < 1000;"),
    ]),
    ("frames: one is sent twice", [
        ("stream/delivery.cpp", "newest.number > sentNumber_;",
         "newest.number >= sentNumber_;"),
    ]),
    ("frames: hidden pages get them, too", [
        ("stream/delivery.cpp", "if (!view_.visible || newest.number == 0) return {};",
         "if (newest.number == 0) return {};"),
        ("stream/delivery.cpp", "if (!view_.visible || !rate_.windowOpen()) return {};",
         "if (!rate_.windowOpen()) return {};"),
    ]),
    ("frames: the limit of all pages holds nothing back", [
        ("room/room_stream.cpp", "const bool free = options_.maxBits <= 0 ||",
         "const bool free = true ||"),
    ]),
    ("stills: those of frames that were not sent begin", [
        ("stream/delivery.cpp", "const bool shown = newest.stream == sentStream_ && newest.number == sentNumber_;",
         "const bool shown = true;"),
    ]),
    ("input: the heartbeat is not checked", [
        ("control/input_state.h", "now - last_ < kHeartbeat",
         "now - last_ < 1e9"),
    ]),
    ("input: old messages count", [
        ("control/input_state.h", "if (input.sequence <= sequence_) return false;",
         ""),
    ]),
    ("input: viewers walk", [
        ("room/room.cpp", "if (!roles_.drives(id)) return;",
         ""),
    ]),
    ("input: keys stay when another drives", [
        ("room/room.cpp", "input_.release(before, *commands_);",
         ""),
    ]),
    ("requests: viewers command", [
        ("room/room_requests.cpp", "if (!planned.anyone && !drives)",
         "if (false)"),
    ]),
    ("requests: edits are not locked", [
        ("control/requests.cpp", "if (command.browser == BrowserUse::Edit && limits.isLocked(\"edits\") && !visitors)",
         "if (false)"),
    ]),
    ("requests: settings have no caps", [
        ("control/caps.h", "std::min(setting.browser.maximum, setting.maximum)",
         "setting.maximum"),
    ]),
    ("requests: edits of others are taken back", [
        ("control/own_edits.h", "edit.person == static_cast<int>(by);",
         "true;"),
    ]),
    ("requests: an edit that changed nothing is one's own", [
        ("control/own_edits.h", "edit.person != 0 && edit.person == static_cast<int>(by);",
         "edit.number != 0;"),
    ]),
    ("requests: several undos are taken at once", [
        ("control/own_edits.h", "bool busy() const { return underWay_ > 0 || unread_; }",
         "bool busy() const { return false; }"),
    ]),
    ("requests: commands change what is locked", [
        ("control/requests.cpp", "if (limits.isLocked(name)) throw",
         "if (false) throw"),
    ]),
    ("requests: any size is taken", [
        ("control/requests.cpp", "if (width * height > static_cast<double>(context.limits.maxPixels))",
         "if (false)"),
    ]),
    ("requests: heavy edits stay", [
        ("room/room_requests.cpp", "if (!heavy.empty()) {",
         "if (false) {"),
    ]),
    ("requests: edits that mend heavy frames are set back", [
        ("room/heavy_edits.cpp", "if (server.hasStatus && server.longestFrame() > kLongFrame) return;",
         ""),
    ]),
    ("requests: whole frames may last", [
        ("room/known_server.h", "return std::max(status.frameSeconds, status.wholeSeconds);",
         "return status.frameSeconds;"),
    ]),
    ("requests: what was quick is watched for ever", [
        ("room/room_requests.cpp", "if (moving_ == 0 && server_.status.idle != 0)",
         "if (false)"),
    ]),
    ("input: what was tapped without a server goes to the next one", [
        ("control/command_link.cpp", "taps.clear(); right = up = 0;",
         ""),
    ]),
    ("roles: a viewer's link drives", [
        ("control/roles.cpp", "const bool drives = person.mayDrive && !driver_;",
         "const bool drives = !driver_;"),
    ]),
    ("door: Origin is compared by its beginning", [
        ("net/doorkeeper.cpp", "return small == (names.tls ? \"https://\" : \"http://\") + lower(host);",
         "return small.starts_with((names.tls ? \"https://\" : \"http://\") + lower(host));"),
    ]),
    ("door: Origin is not compared", [
        ("net/doorkeeper.cpp", "return small == (names.tls ? \"https://\" : \"http://\") + lower(host);",
         "return true;"),
    ]),
    ("door: any Host is the bridge's", [
        ("net/doorkeeper.cpp", "return isLoopback(small) ||",
         "return !small.empty() || isLoopback(small) ||"),
    ]),
    ("door: a token is compared by its beginning", [
        ("net/doorkeeper.cpp", "given.size() == token.size() && !token.empty() ? 0 : 1;",
         "!token.empty() ? 0 : 1;"),
    ]),
    ("door: a driver's link is good again", [
        ("admission.cpp", "used_.push_back(std::exchange(tokens_.driver, newToken()));",
         ""),
    ]),
    ("door: a page that was left may come back for ever", [
        ("admission.cpp", "each.pages == 0 && now > each.until;",
         "false;"),
    ]),
    ("door: a page that is loaded again is another one", [
        ("admission.cpp", "now + (inOrder ? kLoadedAgain : kLost)",
         "now - 1"),
    ]),
    ("door: a refused hello uses the link up", [
        ("visitor.cpp", "if (right == Right::None) {",
         "if (Room* const any = reception_.room(\"\")) reception_.enter(*any, token, right); if (right == Right::None) {"),
    ]),
    ("door: a request may have a body", [
        ("net/http_connection-inl.h", "request.count(http::field::transfer_encoding) +",
         ""),
    ]),
    ("door: parts of messages are not counted", [
        ("net/receiving_limit.h",
         "if (over_ || (bytes_.take(nowSeconds(), static_cast<double>(count)) && unfinished_ <= maxUnfinished_)) return;",
         "return;"),
    ]),
    ("door: a message may never end", [
        ("net/receiving_limit.h", "&& unfinished_ <= maxUnfinished_",
         ""),
    ]),
    ("door: messages are not counted", [
        ("net/http_connection-inl.h", "limit().messageCame(); if (!bucket_.take(nowSeconds()))",
         "limit().messageCame(); if (false)"),
    ]),
    ("door: the silent keep their places", [
        ("hub.cpp", "visitors_ < options_.clients || makeRoom();",
         "visitors_ < options_.clients;"),
    ]),
    ("door: whoever came first makes room", [
        ("net/doorkeeper.cpp", "return static_cast<std::size_t>(busiest - addresses.begin());",
         "return 0;"),
    ]),
    ("door: a close may last for ever", [
        ("net/http_connection-inl.h", "if (!error && self) self->abandon();",
         "if (error && self) self->abandon();"),
    ]),
    ("door: who leaves stays in the room", [
        ("net/http_connection-inl.h", "if (receiver_) receiver_->leaves();",
         ""),
    ]),
    ("page: a still is drawn over a newer frame", [
        ("page/js/painter.js", "(type === STILL && number === this.shown.number && !this.shown.exact)",
         "type === STILL"),
    ]),
    ("page: an old frame is drawn", [
        ("page/js/painter.js", "return number > this.shown.number ||",
         "return true ||"),
    ]),
    ("page: frames that are not drawn are not acknowledged", [
        ("page/js/painter.js", "if (header.type === FRAME) this.skipped.push(",
         "if (false) this.skipped.push("),
    ]),
    ("page: a key waits until the last message is repeated", [
        ("page/js/held.js", "clearTimeout(this.timer); this.timer = setTimeout(() => this.flush(), wait);",
         "if (!this.timer) this.timer = setTimeout(() => { this.timer = 0; this.flush(); }, wait);"),
    ]),
    ("page: strips are drawn one over another", [
        ("page/js/jpeg_strips.js", "strips.push({ top, bytes:",
         "strips.push({ top: 0, bytes:"),
    ]),
    ("page: a still of missing parts is drawn", [
        ("page/js/painter.js", "header.offset === still.filled && still.filled + part.length <= still.bytes.length;",
         "true;"),
    ]),
]


def caught(build):
    page = build.parent / "sources" / BRIDGE / "page" / "js"
    return mutants.first_failure_of(build, PROGRAMS, os.environ | {"RT_PAGE_MODULES": str(page)})


if __name__ == "__main__":
    sys.exit(mutants.main("check_bridge_mutants", BRIDGE, MUTANTS, [program for program, *_ in PROGRAMS], caught))
