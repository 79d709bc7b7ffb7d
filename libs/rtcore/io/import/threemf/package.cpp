#include "rtcore/io/import/threemf/package.h"

#include "rtcore/io/import/materials/texture_files.h"
#include "rtcore/io/import/text/statement_text.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"

#include <minizip/unzip.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace rtcore::threemf {

namespace {

constexpr std::size_t kUnpacked = 65536;               ///< bytes at a time
constexpr std::uint64_t kAlwaysUnpacked = 256'000'000; ///< bytes
constexpr std::uint64_t kMaxGain = 200;                ///< models are packed to a tenth
constexpr std::uint64_t kMaxParts = 100'000;

[[noreturn]] void refusePackage(const Sentence& why) { throw FileError(FailureKind::BadData, "", why); }

[[noreturn]] void refuseDamagedPart(std::string_view name) {
    refusePackage(say("its part {0} is damaged; copy or export it again", name));
}

/// The file as minizip reads it: opened once, whatever happens to its name.
struct Source {
    InputFile file;
    std::uint64_t at = 0;
};

voidpf openSource(voidpf opaque, const void* /*name*/, int /*mode*/) { return opaque; }

uLong readSource(voidpf /*opaque*/, voidpf stream, void* room, uLong size) {
    auto& source = *static_cast<Source*>(stream);
    const std::size_t read = source.file.readAt(source.at, {static_cast<std::byte*>(room), size});
    source.at += read;
    return read;
}

uLong writeSource(voidpf /*opaque*/, voidpf /*stream*/, const void* /*bytes*/, uLong /*size*/) { return 0; }

ZPOS64_T tellSource(voidpf /*opaque*/, voidpf stream) { return static_cast<Source*>(stream)->at; }

long seekSource(voidpf /*opaque*/, voidpf stream, ZPOS64_T offset, int origin) {
    auto& source = *static_cast<Source*>(stream);
    const std::uint64_t from = origin == SEEK_SET ? 0 : origin == SEEK_CUR ? source.at : source.file.size();
    if (from + offset > source.file.size()) return -1;
    source.at = from + offset;
    return 0;
}

int closeSource(voidpf /*opaque*/, voidpf /*stream*/) { return 0; }
int errorOfSource(voidpf /*opaque*/, voidpf /*stream*/) { return 0; }

} // namespace

std::string partKey(std::string_view name) {
    while (name.starts_with('/') || name.starts_with('\\')) name.remove_prefix(1);
    std::string key = inSmallLetters(percentDecoded(std::string(name)));
    std::ranges::replace(key, '\\', '/');
    return key;
}

struct Package::Archive {
    explicit Archive(const std::filesystem::path& path) : source{InputFile(path)} {
        zlib_filefunc64_def calls{openSource, readSource,  writeSource,   tellSource,
                                  seekSource, closeSource, errorOfSource, &source};
        zip = unzOpen2_64("", &calls);
    }
    ~Archive() {
        if (zip != nullptr) unzClose(zip);
    }
    Archive(const Archive&) = delete;
    Archive& operator=(const Archive&) = delete;

    Source source;
    unzFile zip = nullptr;
};

Package::Package(const std::filesystem::path& path, const std::function<void()>& alive)
    : archive_(std::make_unique<Archive>(path)), alive_(alive) {
    if (archive_->zip == nullptr) {
        refusePackage(
            say("the list of what it holds, at its end, is missing or damaged; copy or export it again"));
    }
    budget_ = std::max(kAlwaysUnpacked, kMaxGain * archive_->source.file.size());
    std::array<char, 1024> name{};
    for (int at = unzGoToFirstFile(archive_->zip); at == UNZ_OK; at = unzGoToNextFile(archive_->zip)) {
        unz_file_info64 info{};
        const int known = unzGetCurrentFileInfo64(archive_->zip, &info, name.data(), name.size() - 1, nullptr,
                                                  0, nullptr, 0);
        unz64_file_pos position{};
        if (known != UNZ_OK || unzGetFilePos64(archive_->zip, &position) != UNZ_OK) break;
        if (parts_.size() >= kMaxParts)
            refusePackage(say("it holds more than {0} files, as no model does", kMaxParts));
        const std::string key = partKey(name.data());
        if (info.size_filename >= name.size() || key.empty() || key.ends_with('/')) continue;
        // Of two parts with one name the first counts, whichever program reads them.
        if (parts_.try_emplace(key, Position{position.pos_in_zip_directory, position.num_of_file}).second)
            names_.emplace(key, name.data());
    }
}

Package::~Package() = default;

void Package::refuseBeyondBudget(std::uint64_t unpacked) const {
    if (unpacked <= budget_) return;
    refusePackage(
        say("it unpacks to more than {0} times its size, as no model does; it is damaged or made to fill "
            "memory",
            kMaxGain));
}

void Package::read(std::string_view name, const std::function<void(std::span<const char>)>& use) {
    const auto part = parts_.find(partKey(name));
    if (part == parts_.end()) refusePackage(say("its part {0} is missing; copy or export it again", name));
    unz64_file_pos position{part->second.offset, part->second.number};
    const unzFile zip = archive_->zip;
    unz_file_info64 info{};
    if (unzGoToFilePos64(zip, &position) != UNZ_OK ||
        unzGetCurrentFileInfo64(zip, &info, nullptr, 0, nullptr, 0, nullptr, 0) != UNZ_OK) {
        refuseDamagedPart(name);
    }
    if ((info.flag & 1U) != 0)
        refusePackage(say("its part {0} is locked by a password; export it without", name));
    refuseBeyondBudget(info.uncompressed_size); // no more is unpacked, whatever the bytes hold
    if (unzOpenCurrentFile(zip) != UNZ_OK) refuseDamagedPart(name);
    std::array<char, kUnpacked> piece;
    for (;;) {
        const int count = unzReadCurrentFile(zip, piece.data(), static_cast<unsigned>(piece.size()));
        if (count < 0) refuseDamagedPart(name);
        if (count == 0) break;
        budget_ -= std::min(budget_, static_cast<std::uint64_t>(count));
        use({piece.data(), static_cast<std::size_t>(count)});
        alive_();
    }
    if (unzCloseCurrentFile(zip) != UNZ_OK) refuseDamagedPart(name);
}

std::string Package::bytes(std::string_view name, std::size_t max) {
    std::string all;
    read(name, [&](std::span<const char> piece) {
        if (all.size() + piece.size() > max)
            refusePackage(say("its part {0} is larger than {1} bytes", name, max));
        all.append(piece.data(), piece.size());
    });
    return all;
}

} // namespace rtcore::threemf
