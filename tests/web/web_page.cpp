#include "web/web_page.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>

namespace test {

namespace {

// Reads back the pixels as the screen gets them: no conversion, no alpha.
constexpr const char* kReadBack = R"((() => {
    const view = document.getElementById("view"), copy = document.createElement("canvas");
    copy.width = view.width;
    copy.height = view.height;
    const context = copy.getContext("2d", { alpha: false });
    context.drawImage(view, 0, 0);
    const all = context.getImageData(0, 0, copy.width, copy.height).data;
    let text = "";
    for (let i = 0; i < all.length; ++i) if (i % 4 !== 3) text += String.fromCharCode(all[i]);
    return btoa(text);
})())";

std::string decodeBase64(const std::string& text) {
    std::string bytes;
    unsigned bits = 0, held = 0;
    for (const char letter : text) {
        constexpr std::string_view kLetters =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        const auto value = kLetters.find(letter);
        if (value == std::string_view::npos) break;
        held = held << 6U | static_cast<unsigned>(value);
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes += static_cast<char>(held >> bits & 255U);
    }
    return bytes;
}

struct NamedKey {
    const char *code, *key;
    int number; ///< as Windows has it, which the browser asks for
};
constexpr std::array<NamedKey, 6> kNamed{{{"Enter", "Enter", 13},
                                          {"ControlLeft", "Control", 17},
                                          {"Escape", "Escape", 27},
                                          {"Space", " ", 32},
                                          {"Tab", "Tab", 9},
                                          {"F3", "F3", 114}}};

Json keyEvent(const std::string& code, const char* type) {
    const auto named =
        std::find_if(kNamed.begin(), kNamed.end(), [&](const NamedKey& one) { return code == one.code; });
    if (named != kNamed.end())
        return {
            {"type", type}, {"code", code}, {"key", named->key}, {"windowsVirtualKeyCode", named->number}};
    const char letter = code.back();
    const std::string key(1, static_cast<char>(std::tolower(static_cast<unsigned char>(letter))));
    return {
        {"type", type}, {"code", code}, {"key", key}, {"windowsVirtualKeyCode", static_cast<int>(letter)}};
}

} // namespace

WebPage::WebPage(Chromium& browser, const std::string& address,
                 const std::vector<std::pair<std::string, std::string>>& media)
    : WebPage(browser, address, media, browser.call("Target.createBrowserContext")["browserContextId"]) {}

WebPage::WebPage(Chromium& browser, const std::string& address,
                 const std::vector<std::pair<std::string, std::string>>& media, const std::string& context)
    : browser_(&browser), context_(context),
      target_(browser.call("Target.createTarget",
                           context.empty()
                               ? Json{{"url", "about:blank"}}
                               : Json{{"url", "about:blank"}, {"browserContextId", context}})["targetId"]),
      session_(
          browser.call("Target.attachToTarget", {{"targetId", target_}, {"flatten", true}})["sessionId"]) {
    for (const char* domain : {"Page", "Runtime", "Log", "Audits", "Network"})
        call(std::string(domain) + ".enable");
    Json features = Json::array();
    for (const auto& [name, wanted] : media) features.push_back({{"name", name}, {"value", wanted}});
    call("Emulation.setEmulatedMedia", {{"features", features}});
    open(address);
}

Json WebPage::call(const std::string& method, const Json& parameters) const {
    return browser_->call(method, parameters, session_);
}

void WebPage::open(const std::string& address) const { call("Page.navigate", {{"url", address}}); }

Json WebPage::value(const std::string& expression) const {
    const Json answer = call(
        "Runtime.evaluate",
        {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}, {"userGesture", true}});
    if (answer.contains("exceptionDetails")) throw std::runtime_error(answer["exceptionDetails"].dump());
    return answer["result"].value("value", Json());
}

void WebPage::leave(const std::string& script) const { value("void setTimeout(() => { " + script + " })"); }

bool WebPage::becomes(const std::string& expression, std::chrono::seconds within) const {
    const auto deadline = Clock::now() + within;
    for (;;) {
        // While a page is being opened there is nothing to ask.
        try {
            if (value("Boolean(" + expression + ")") == true) return true;
        } catch (const std::runtime_error&) {
            if (Clock::now() > deadline) throw;
        }
        if (Clock::now() > deadline) return false;
        browser_->listen(20ms);
    }
}

void WebPage::keyDown(const std::string& code) const {
    call("Input.dispatchKeyEvent", keyEvent(code, "rawKeyDown"));
}
void WebPage::keyUp(const std::string& code) const {
    call("Input.dispatchKeyEvent", keyEvent(code, "keyUp"));
}

void WebPage::click(double x, double y) const {
    for (const char* type : {"mousePressed", "mouseReleased"})
        call("Input.dispatchMouseEvent",
             {{"type", type}, {"x", x}, {"y", y}, {"button", "left"}, {"clickCount", 1}});
}

void WebPage::hide() {
    const Json other =
        browser_->call("Target.createTarget", {{"url", "about:blank"}, {"browserContextId", context_}});
    browser_->call("Target.activateTarget", {{"targetId", other["targetId"]}});
}
void WebPage::show() const { browser_->call("Target.activateTarget", {{"targetId", target_}}); }

std::string WebPage::pixels() const { return decodeBase64(value(kReadBack)); }

void WebPage::screenshot(const std::string& file) const {
    std::ofstream(file, std::ios::binary)
        << decodeBase64(call("Page.captureScreenshot", {{"format", "png"}})["data"]);
}

std::vector<std::string> WebPage::complaints() const {
    browser_->listen(50ms);
    std::vector<std::string> all;
    for (const Json& event : browser_->events(session_)) {
        const std::string method = event.value("method", "");
        if (method == "Runtime.consoleAPICalled" || method == "Runtime.exceptionThrown" ||
            method == "Log.entryAdded" || method == "Audits.issueAdded")
            all.push_back(event.dump());
    }
    return all;
}

} // namespace test
