/// The trained weights of the nets: which files there are, where they lie, and whether they are the right
/// ones. They are Intel's and no part of the suite; scripts/fetch-nets.sh brings them.
#pragma once

#include "rtcore/neural/u_net.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/sentence.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace rtcore {

/// Radiance with albedo and normals without noise, by nets of three sizes; with noisy ones, as a lens makes
/// them; radiance alone.
enum class Net { Small, Base, Large, NoisyAovs, Colour, Last = Colour };

/// One file of weights. Another file of the same name gives other images, so that it is refused.
struct NetFile {
    Net net;
    const char* name; ///< for people and settings
    const char* file;
    std::uint64_t bytes;
    const char* sha256; ///< 64 digits, in lower case
};
inline constexpr std::array kNetFiles{
    NetFile{Net::Small, "small", "rt_hdr_calb_cnrm_small.tza", 641480,
            "a6c43bfdbff01bdd8a9c777e139720f9e58b872a50c8db07079bddd007482dc5"},
    NetFile{Net::Base, "base", "rt_hdr_calb_cnrm.tza", 1841160,
            "d0057057bd76c64e3e67b449728ef8f4fd2f11ccfb74c1e59b9d50dafd50ee0e"},
    NetFile{Net::Large, "large", "rt_hdr_calb_cnrm_large.tza", 7698439,
            "08130cdc4f33b7a513d0073757f089ac830f900613bb5bad72ca42c52b934465"},
    NetFile{Net::NoisyAovs, "noisyAovs", "rt_hdr_alb_nrm.tza", 1841160,
            "e586ef2ff48d7fbb7611986405220ed8fc5c13ca79bfc40be4dc742fbf959e1a"},
    NetFile{Net::Colour, "colour", "rt_hdr.tza", 1830792,
            "a097e8fe9b1ba71ec43cde3e6df3fcf54fa4f8f2f4dd41eac01d0a76a16261e3"},
};
static_assert(kNetFiles.size() == static_cast<std::size_t>(Net::Last) + 1);

constexpr const NetFile& fileOf(Net net) { return kNetFiles[static_cast<std::size_t>(net)]; }

/// The folders in which nets are looked for, the first one first: `chosen` alone (of an option); without that
/// the one of the environment variable RT_NETS alone; else rtsuite/nets in the user's folder for data,
/// ../share/rtsuite/nets as seen from `programs`, and, where that is the folder of programs of a build,
/// `nets` beside this build. `programs`: the folder of the running program. Those that are missing are named,
/// too.
std::vector<std::filesystem::path> netFolders(const std::filesystem::path& chosen = {},
                                              const std::filesystem::path& programs = programFolder());

/// Either a file, which was not looked into, or why there is none and what to do.
struct FoundNet {
    std::filesystem::path file; ///< empty: none
    Sentence missing;           ///< "denoise.net: no weights in ...; scripts/setup.sh --nets brings them"
};
/// In the first of netFolders() that has it.
FoundNet findNet(const NetFile& net, const std::filesystem::path& chosen = {},
                 const std::filesystem::path& programs = programFolder());

/// Reads the file of a net once, and checks its size and its digest before anything in it is believed. Throws
/// FileError, which says what to do: NoInput; BadData for another file, and for any file where this build
/// cannot compute digests.
std::shared_ptr<const UNet> readNet(const NetFile& net, const std::filesystem::path& file);

} // namespace rtcore
