/// A page in a Chromium: opens an address, runs scripts, presses keys.
#pragma once

#include "web/chromium.h"

#include <functional>
#include <string>
#include <vector>

namespace test {

class WebPage {
  public:
    /// In storage of its own, as of another user. `media`: features by name, such as prefers-color-scheme.
    WebPage(Chromium& browser, const std::string& address,
            const std::vector<std::pair<std::string, std::string>>& media = {});
    /// In the browser's own profile, which it keeps on its disk.
    static WebPage ofProfile(Chromium& browser, const std::string& address) {
        return {browser, address, {}, ""};
    }

    Json call(const std::string& method, const Json& parameters = Json::object()) const;
    void open(const std::string& address) const;
    /// The value of an expression, waited for where it is a promise. Throws std::runtime_error where it
    /// throws.
    Json value(const std::string& expression) const;
    /// Runs a script by which the page is left: after the answer, which would be lost with the page.
    void leave(const std::string& script) const;
    /// Until the expression is true; false when the time is up before.
    bool becomes(const std::string& expression, std::chrono::seconds within = std::chrono::seconds(20)) const;

    /// Trusted events. `code`: as in KeyboardEvent.code.
    void keyDown(const std::string& code) const;
    void keyUp(const std::string& code) const;
    void click(double x, double y) const;
    /// Another page comes before this one, as another tab does; and back.
    void hide();
    void show() const;
    void close() const { browser_->call("Target.closeTarget", {{"targetId", target_}}); }
    /// The image that is shown, 3 bytes a pixel.
    std::string pixels() const;
    void screenshot(const std::string& file) const;
    std::vector<Json> events() const { return browser_->events(session_); }
    /// Messages in the console, exceptions, and what the browser reports (policy, mixed content, ...).
    std::vector<std::string> complaints() const;

  private:
    WebPage(Chromium& browser, const std::string& address,
            const std::vector<std::pair<std::string, std::string>>& media, const std::string& context);

    Chromium* browser_;
    std::string context_, target_, session_;
};

} // namespace test
