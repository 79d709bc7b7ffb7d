#include "bridge/bridge_options.h"

#include "common/cli/file_notes.h"
#include "common/cli/instance_option.h"
#include "common/cli/parent_option.h"

#include "ipc/endpoint/instances.h"
#include "ipc/platform/names.h"

#include <fmt/core.h>

#include <algorithm>

namespace bridge {

namespace {

using app::ValueKind;

#ifdef RT_BRIDGE_TLS
constexpr bool kHasTls = true;
#else
constexpr bool kHasTls = false;
#endif

constexpr std::uint16_t kPort = 8931;
constexpr int kPorts = 20; ///< that are tried where none is asked for

std::vector<std::string> suggestServers(std::span<const std::string>) {
    std::vector<std::string> names;
    for (const ipc::Instance& each : ipc::listInstances())
        if (each.running) names.emplace_back(each.name);
    return names;
}

app::OptionGroup serverOptions() {
    return {
        "Server",
        {{.name = "instance",
          .letter = 'i',
          .value = ValueKind::Text,
          .argument = "NAME",
          .help =
              "the server's name; may be given several times, and pages choose [that of the only one that "
              "runs]",
          .suggest = suggestServers},
         {.name = "start",
          .value = ValueKind::Text,
          .argument = "FILE",
          .help = "start an RTServer with this scene or model, which ends with the bridge",
          .files = app::sceneExtensions()},
         app::parentOption()}};
}

app::OptionGroup addressOptions() {
    return {
        "Address",
        {{.name = "listen",
          .value = ValueKind::Text,
          .argument = "ADDRESS",
          .help = "an address, ADDRESS:PORT, or unix for a socket that only this user can open [127.0.0.1]",
          .more =
              "Without a port it is 8931, or the next free one. With `unix` the command line for `ssh -L` "
              "is printed. An address that other machines reach takes TLS"},
         {.name = "origin",
          .value = ValueKind::Text,
          .argument = "URL",
          .help = "the page's address behind a proxy, such as https://viz.example/node7/"},
         {.name = "ping",
          .value = ValueKind::Number,
          .argument = "S",
          .help = "seconds after which a silent connection gets a ping, for proxies that cut those [15]",
          .minimum = 1,
          .maximum = kPingSeconds},
         {.name = "allow-no-origin",
          .help = "serve clients that send no Origin: programs, which are no web pages"},
         {.name = "tls-cert",
          .value = ValueKind::Text,
          .argument = "FILE",
          .help = "certificates in PEM, for https",
          .files = {"pem", "crt"}},
         {.name = "tls-key",
          .value = ValueKind::Text,
          .argument = "FILE",
          .help = "the key of the certificate",
          .files = {"pem", "key"}},
         {.name = "tls-own",
          .help = "https by a certificate that is made for this machine, and kept",
          .more = "Browsers do not know it and ask whether to go on; its fingerprint is printed, to compare"},
         {.name = "insecure", .help = "let other machines in without TLS: who listens can read all of it"}}};
}

app::OptionGroup permissionOptions() {
    return {
        "Permissions",
        {{.name = "view-only", .help = "pages cannot drive"},
         {.name = "token-file",
          .value = ValueKind::Text,
          .argument = "FILE",
          .help = "keep the links: tokens are read from this file, or written to it [new ones each time]",
          .more =
              "The driver's is good again and again then: for programs, and where no browser's history is "
              "read by others"},
         {.name = "lock",
          .value = ValueKind::Text,
          .argument = "NAME,...",
          .help =
              "settings that pages cannot change; fog.*: all of that group; edits: no settings, lights or "
              "materials at all"},
         {.name = "visitor-notes",
          .help = "pages that only look may add notes to the scene, with a name",
          .more =
              "Three at once and one every 20 seconds for each page, ten and one every 5 seconds for all, "
              "and none where the scene has 500. `--lock=edits` does not forbid them"},
         {.name = "clients",
          .value = ValueKind::Integer,
          .argument = "N",
          .help = "most pages at once [64]",
          .minimum = 1,
          .maximum = 1000},
         {.name = "max-pixels",
          .value = ValueKind::Integer,
          .argument = "N",
          .help = "most pixels of a frame that a page may ask for [2073600]",
          .minimum = 1,
          .maximum = 1 << 28},
         {.name = "max-mbit",
          .value = ValueKind::Number,
          .argument = "X",
          .help = "most megabits per second for all pages together, shared evenly by the servers; 0 is no "
                  "limit [0]",
          .minimum = 0,
          .maximum = 1e6}}};
}

app::OptionGroup runningOptions() {
    return {
        "Running",
        {{.name = "quality",
          .value = ValueKind::Text,
          .argument = "Q",
          .help = "of moving frames: auto, by the link of each page; or 50 to 95, the quality of JPEG, at "
                  "full size [auto]",
          .more = "Pages may still choose another, and `--max-mbit` counts first. At rest each pixel is "
                  "exact in any case",
          .suggest =
              [](std::span<const std::string>) {
                  return std::vector<std::string>{"auto", "60", "75", "85", "95"};
              }},
         {.name = "rest",
          .value = ValueKind::Choice,
          .argument = "R",
          .help = "the image at rest: paths, with all light that surfaces send to each other and its noise "
                  "taken away; or live, the server's own frame [paths]",
          .more = "By paths a Renderer on this machine makes it, which keeps the model in memory for ten "
                  "minutes after the last image",
          .choices = {"paths", "live"}},
         {.name = "watch",
          .help =
              "print a line a second for each server on standard error: pages, driver, frames and bits that "
              "are sent, processor time"}}};
}

std::string onlyServer() {
    std::vector<std::string> running;
    for (const ipc::Instance& each : ipc::listInstances())
        if (each.running && !each.name.starts_with(app::kPreviewPrefix)) running.push_back(each.name);
    return running.size() == 1 ? running.front() : "default";
}

/// Each once.
std::vector<std::string> instancesOf(const app::Arguments& arguments) {
    std::vector<std::string> names;
    for (std::string& each : arguments.all("instance"))
        if (std::ranges::find(names, each) == names.end()) names.push_back(std::move(each));
    if (names.empty())
        names.push_back(app::instanceOf(arguments).value_or(
            arguments.has("start") ? ipc::availableName("default") : onlyServer()));
    for (const std::string& each : names) {
        try {
            ipc::Names checked(each);
        } catch (const ipc::Error& error) {
            throw app::UsageError(error.what());
        }
    }
    return names;
}

ListenAddress listenOf(const std::optional<std::string>& given) {
    if (!given) return {"127.0.0.1", kPort, {}, kPorts};
    if (*given == "unix") return {{}, 0, "unix", 1};
    const auto fail = [&] {
        return app::UsageError("option '--listen' takes an address, ADDRESS:PORT or unix, not '" + *given +
                               "'");
    };
    const bool isSix = given->find(':') != given->rfind(':') && !given->starts_with('[');
    const std::size_t colon = given->ends_with(']') || isSix ? std::string::npos : given->rfind(':');
    const bool hasPort = colon != std::string::npos;
    std::string host = given->substr(0, colon);
    if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
    if (host == "localhost") host = "127.0.0.1";
    if (host.find_first_not_of("0123456789") == std::string::npos) throw fail(); // a port alone
    if (!hasPort) return {host, kPort, {}, kPorts};
    constexpr std::int64_t kMaxPort = 65535;
    const auto port = app::parseInteger(given->substr(colon + 1));
    if (!port || *port < 0 || *port > kMaxPort) throw fail();
    return {host, static_cast<std::uint16_t>(*port), {}, 1};
}

/// "fog.*": all settings of that group; else the one of that name, or "edits".
std::vector<std::string> lockedBy(const std::string& name) {
    if (name == "edits") return {name};
    if (!name.ends_with(".*")) return {std::string(rtcore::requireSetting(name).name)};
    std::vector<std::string> names;
    for (const rtcore::Setting& each : rtcore::settingsTable())
        if (each.name.starts_with(name.substr(0, name.size() - 1))) names.emplace_back(each.name);
    if (names.empty()) throw std::invalid_argument("there are no settings '" + name + "'");
    return names;
}

std::vector<std::string> lockedOf(const std::string& list) {
    std::vector<std::string> names;
    for (std::size_t start = 0; start <= list.size();) {
        const std::size_t end = std::min(list.find(',', start), list.size());
        const std::string name = list.substr(start, end - start);
        start = end + 1;
        if (name.empty()) continue;
        try {
            for (std::string& each : lockedBy(name))
                if (std::ranges::find(names, each) == names.end()) names.push_back(std::move(each));
        } catch (const std::invalid_argument& error) {
            throw app::UsageError(std::string("option '--lock': ") + error.what());
        }
    }
    return names;
}

std::optional<int> qualityOf(const std::optional<std::string>& given) {
    if (!given || *given == "auto") return {};
    constexpr std::int64_t kMin = 50, kMax = 95;
    const auto quality = app::parseInteger(*given);
    if (!quality || *quality < kMin || *quality > kMax)
        throw app::UsageError("option '--quality' takes auto or 50 to 95, not '" + *given + "'");
    return static_cast<int>(*quality);
}

void checkSafety(const BridgeOptions& options, bool insecure) {
    const bool here = !options.listen.socketPath.empty() || options.listen.host.starts_with("127.") ||
                      options.listen.host == "::1";
    if (here || insecure || options.names.tls) return;
    throw app::UsageError(
        "other machines reach " + options.listen.host +
        ": listen to 127.0.0.1 and use 'ssh -L 8931:127.0.0.1:8931', or give --tls-own, or --tls-cert "
        "and --tls-key; "
        "--insecure lets everybody in between read pictures and tokens");
}

} // namespace

const app::ProgramSpec& bridgeSpec() {
    static const app::ProgramSpec spec{
        .name = "RTBridge",
        .purpose = "Shows what an RTServer renders in web pages, in which one walks. Prints the links, which "
                   "hold tokens; the driver's is good once, and the next one is printed then.",
        .positionals = {},
        .groups = {serverOptions(), addressOptions(), permissionOptions(), runningOptions()},
        .examples = {{"RTBridge", "beside a running server; open the link that it prints"},
                     {"RTBridge --start nave.scn", "with a server of its own"},
                     {"RTBridge --listen=unix", "on a node of a cluster; prints how to get there by ssh"},
                     {"RTBridge --lock=edits -i hall", "pages may walk, but change nothing"}},
        .environment = {app::instanceEnvironmentNote(),
                        {"RT_RENDERER", "the program that makes images at rest [Renderer, beside RTBridge]"},
                        {"RT_SERVER", "the program that --start runs [RTServer, beside RTBridge]"},
                        {"XDG_STATE_HOME", "the folder for the certificate of --tls-own [~/.local/state]"},
                        {"XDG_RUNTIME_DIR", "the folder for the socket of --listen=unix"}},
        .files = {{"TOKENS", "of --token-file: a line with the driver's token, one with the viewer's"},
                  {"$XDG_STATE_HOME/rts/certificate.pem", "the certificate of --tls-own, and its key"},
                  {"$XDG_RUNTIME_DIR/rts/NAME.web", "the socket of --listen=unix"}},
        .features = {{"OpenSSL", kHasTls, "no --tls-cert: https by a proxy or ssh"}},
    };
    return spec;
}

BridgeOptions readBridgeOptions(const app::Arguments& arguments) {
    BridgeOptions options;
    options.instances = instancesOf(arguments);
    options.listen = listenOf(arguments.text("listen"));
    options.tls = {arguments.text("tls-cert").value_or(""), arguments.text("tls-key").value_or("")};
    if (options.tls.certificate.empty() != options.tls.key.empty())
        throw app::UsageError("--tls-cert and --tls-key belong together");
    options.ownCertificate = arguments.has("tls-own");
    if (options.ownCertificate && !options.tls.certificate.empty())
        throw app::UsageError("--tls-own and --tls-cert exclude each other");
    if (options.ownCertificate && !options.listen.socketPath.empty())
        throw app::UsageError("--tls-own is for addresses; what comes to --listen=unix is encrypted by ssh");
    options.names.tls = options.ownCertificate || !options.tls.certificate.empty();
    options.names.allowNoOrigin = arguments.has("allow-no-origin");
    if (const auto origin = arguments.text("origin")) options.origin = parseOrigin(*origin);
    options.limits.locked = lockedOf(arguments.text("lock").value_or(""));
    options.limits.maxPixels = arguments.integer("max-pixels").value_or(options.limits.maxPixels);
    options.limits.visitorNotes = arguments.has("visitor-notes");
    options.viewOnly = arguments.has("view-only");
    options.clients = static_cast<std::size_t>(arguments.integer("clients").value_or(64));
    options.stream.maxBits = 1e6 * arguments.number("max-mbit").value_or(0);
    options.stream.quality = qualityOf(arguments.text("quality"));
    options.byPaths = arguments.text("rest").value_or("paths") == "paths";
    options.watch = arguments.has("watch");
    options.stream.pingSeconds = arguments.number("ping").value_or(kPingSeconds);
    if (const auto file = arguments.text("token-file")) options.tokenFile = *file;
    if (const auto scene = arguments.text("start")) options.start = *scene;
    if (arguments.has("parent")) options.parent = app::parentOf(arguments);
    if (options.start && options.instances.size() > 1) throw app::UsageError("--start takes one --instance");
    checkSafety(options, arguments.has("insecure"));
    return options;
}

} // namespace bridge
