// Reading: whole files, and the beginnings of files.
#include "rtcore/platform/descriptor_posix.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/raw_memory.h"
#include "rtcore/platform/sentence.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <new>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/stat.h>

namespace rtcore {

namespace fs = std::filesystem;

namespace {

/// Larger files are mapped.
constexpr std::size_t kMaxRead = std::size_t{1} << 30;
/// Bytes that a pipe or a device may deliver before it counts as endless.
constexpr std::size_t kStreamLimit = std::size_t{1} << 30;
/// Room that is made for the first bytes of a pipe or a device.
constexpr std::size_t kFirstBytes = std::size_t{64} << 10;

[[noreturn]] void refuse(const fs::path& path, const Sentence& message,
                         FailureKind kind = FailureKind::NoInput) {
    throw FileError(kind, path.string(), message);
}

[[noreturn]] void failReading(const fs::path& path, int error) {
    const char* advice = error == ENOENT || error == ENOTDIR ? form("{0}; check the spelling and the folder")
                         : error == EACCES                   ? form("{0}; check its permissions")
                         : error == EISDIR                   ? form("{0}; name a file in it")
                                                             : "{0}";
    refuse(path, say("cannot be read: {0}", say(advice, systemReason(error))));
}

/// Bytes that are not cleared before they are read: a vector would touch all of them twice.
class Buffer {
  public:
    Buffer() = default;
    ~Buffer() { std::free(data_); }
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

    std::byte* data() { return data_; }
    std::size_t size() const { return size_; }
    void resize(std::size_t size) {
        void* const moved = std::realloc(data_, std::max<std::size_t>(size, 1));
        if (moved == nullptr) throw std::bad_alloc();
        data_ = static_cast<std::byte*>(moved);
        size_ = size;
        // Most of the time of reading is the system's, for each page; with fewer of them it is half of that.
        preferLargePages(data_, size_);
    }

  private:
    std::byte* data_ = nullptr;
    std::size_t size_ = 0;
};

struct Opened {
    Descriptor file; ///< does not block
    bool regular;
    std::size_t size; ///< as the system states it; 0 for what is no regular file
};

/// Checking what is in a file of many gigabytes takes minutes, also where nothing ever was: a file that
/// little of was written is what a copy leaves behind that was stopped.
void refuseHoles(const fs::path& path, const Descriptor& file, const struct stat& status) {
    constexpr off_t kLong = off_t{4} << 30;
    constexpr off_t kBlock = 512; // of st_blocks
    constexpr off_t kPacked = 64; // more than file systems save that pack files
    if (status.st_size <= kLong || status.st_blocks * kBlock >= status.st_size / kPacked) return;
    const bool full = ::lseek(file.get(), 0, SEEK_HOLE) == status.st_size; // some count no blocks
    if (::lseek(file.get(), 0, SEEK_SET) != 0) failReading(path, errno);
    if (full) return;
    refuse(path,
           say("of its {0} MB hardly any were ever written; copy or export it again",
               status.st_size / 1'000'000),
           FailureKind::BadData);
}

Opened openForReading(const fs::path& path) {
    // Opening must not wait: a pipe without a writer would block the program for ever.
    Descriptor file(openRetrying(path, O_RDONLY | O_NONBLOCK));
    if (!file.valid()) failReading(path, errno);
    struct stat status {};
    if (::fstat(file.get(), &status) != 0) failReading(path, errno);
    if (S_ISDIR(status.st_mode)) failReading(path, EISDIR);
    const bool regular = S_ISREG(status.st_mode);
    if (regular) refuseHoles(path, file, status);
    if (!regular && regularFilesOnly()) refuse(path, say("it is no regular file; give a file"));
    constexpr int kMilliseconds = 10'000;
    if (S_ISFIFO(status.st_mode) && !waitUntilReady(file.get(), POLLIN, kMilliseconds))
        refuse(path, say("it is a pipe without a writer; give a file"));
    return {std::move(file), regular, regular ? static_cast<std::size_t>(status.st_size) : 0};
}

/// As many bytes as fit and are there from `offset` on; -1 for an error, which errno tells.
ssize_t readFrom(const Descriptor& file, std::uint64_t offset, std::span<std::byte> room) {
    std::size_t filled = 0;
    while (filled < room.size()) {
        const ssize_t got = ::pread(file.get(), room.data() + filled, room.size() - filled,
                                    static_cast<off_t>(offset + filled));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return -1;
        if (got == 0) break;
        filled += static_cast<std::size_t>(got);
    }
    return static_cast<ssize_t>(filled);
}

/// Reads whole parts of a regular file from its beginning, by the threads of OpenMP. Returns how many bytes,
/// behind which reading goes on; 0 for a file that is short, does not fit or makes errors.
std::size_t readInParts(const Opened& opened, std::span<std::byte> room) {
    constexpr std::size_t kPart = std::size_t{4} << 20;
    if (!opened.regular || opened.size < 2 * kPart || room.size() < opened.size) return 0;
    const std::size_t parts = opened.size / kPart;
    bool whole = true;
#pragma omp parallel for schedule(dynamic, 1) reduction(&& : whole)
    for (std::size_t part = 0; part < parts; ++part) {
        const ssize_t got = readFrom(opened.file, part * kPart, room.subspan(part * kPart, kPart));
        whole = whole && got == static_cast<ssize_t>(kPart);
    }
    const auto end = static_cast<off_t>(parts * kPart);
    return whole && ::lseek(opened.file.get(), end, SEEK_SET) == end ? parts * kPart : 0;
}

/// Reads on until the end, at most `limit` + 1 bytes, into a container of bytes.
template <typename Bytes>
void readToEnd(const fs::path& path, const Opened& opened, std::size_t limit, Bytes& bytes) {
    bytes.resize(std::min(opened.size, limit) + 1);
    std::size_t filled = readInParts(opened, {reinterpret_cast<std::byte*>(bytes.data()), bytes.size()});
    while (true) {
        const std::span<std::byte> room(reinterpret_cast<std::byte*>(bytes.data()), bytes.size());
        const ssize_t got = readWaiting(opened.file.get(), room.subspan(filled));
        if (got < 0) failReading(path, errno);
        if (got == 0) break;
        filled += static_cast<std::size_t>(got);
        if (filled > limit) break;
        if (filled == bytes.size()) bytes.resize(std::min(limit + 1, std::max(filled * 2, kFirstBytes)));
    }
    bytes.resize(filled);
    if (filled > limit)
        refuse(path, say("holds more than {0} bytes; no file of this kind is so large", limit),
               FailureKind::BadData);
}

/// Null where the file cannot be mapped.
std::shared_ptr<const void> mapFile(const Opened& opened) {
    void* address = ::mmap(nullptr, opened.size, PROT_READ, MAP_PRIVATE, opened.file.get(), 0);
    if (address == MAP_FAILED) return nullptr;
    return {address, [size = opened.size](const void* p) { ::munmap(const_cast<void*>(p), size); }};
}

FileBytes readAll(const fs::path& path, const Opened& opened) {
    if (opened.size > kMaxRead) {
        if (auto mapping = mapFile(opened)) {
            const auto* first = static_cast<const std::byte*>(mapping.get());
            return {{first, opened.size}, std::move(mapping)};
        }
    }
    const auto bytes = std::make_shared<Buffer>();
    readToEnd(path, opened, std::max(opened.size, kStreamLimit), *bytes);
    return {{bytes->data(), bytes->size()}, bytes};
}

} // namespace

FileBytes openFileBytes(const fs::path& path) { return readAll(path, openForReading(path)); }

struct InputFile::Parts {
    explicit Parts(const fs::path& name) : path(name), opened(openForReading(name)) {}

    fs::path path;
    Opened opened;
    Buffer first;
    FileBytes stream; ///< all of what can be read only once
    bool streamed = false;
};

InputFile::InputFile(const fs::path& path) : parts_(std::make_unique<Parts>(path)) {}
InputFile::~InputFile() = default;
InputFile::InputFile(InputFile&& other) noexcept = default;
InputFile& InputFile::operator=(InputFile&& other) noexcept = default;

std::span<const std::byte> InputFile::head(std::size_t max) {
    Parts& parts = *parts_;
    if (!parts.opened.regular) {
        if (!parts.streamed) parts.stream = readAll(parts.path, parts.opened);
        parts.streamed = true;
        return parts.stream.bytes.first(std::min(max, parts.stream.bytes.size()));
    }
    parts.first.resize(std::min(max, parts.opened.size));
    return {parts.first.data(), readAt(0, {parts.first.data(), parts.first.size()})};
}

std::uint64_t InputFile::size() const { return parts_->opened.size; }

std::size_t InputFile::readAt(std::uint64_t offset, std::span<std::byte> room) const {
    const ssize_t got = readFrom(parts_->opened.file, offset, room);
    if (got < 0) failReading(parts_->path, errno);
    return static_cast<std::size_t>(got);
}

FileBytes InputFile::read() {
    return parts_->streamed ? std::move(parts_->stream) : readAll(parts_->path, parts_->opened);
}

std::string readTextFile(const fs::path& path, std::size_t limit) {
    std::string text;
    readToEnd(path, openForReading(path), limit, text);
    return text;
}

struct LineReader::Parts {
    fs::path name;
    Descriptor file;
    std::string text = {}; ///< read, and not handed out
    bool ended = false;
};

LineReader::LineReader(const fs::path& path)
    : parts_(path == "-" ? new Parts{"standard input", Descriptor(::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0))}
                         : new Parts{path, std::move(openForReading(path).file)}) {}
LineReader::~LineReader() = default;

std::optional<std::string> LineReader::next() {
    constexpr std::size_t kLongest = std::size_t{1} << 20;
    Parts& parts = *parts_;
    std::size_t end = parts.text.find('\n');
    while (end == std::string::npos && !parts.ended) {
        if (parts.text.size() > kLongest)
            refuse(parts.name, say("holds a line of more than a megabyte; it is no text"),
                   FailureKind::BadData);
        std::array<char, 4096> piece{};
        // Standard input belongs to others, too, and so it blocks.
        waitUntilReady(parts.file.get(), POLLIN);
        const ssize_t got = readWaiting(parts.file.get(), std::as_writable_bytes(std::span(piece)));
        if (got < 0) failReading(parts.name, errno);
        parts.ended = got == 0;
        const std::size_t before = parts.text.size();
        parts.text.append(piece.data(), static_cast<std::size_t>(got));
        end = parts.text.find('\n', before);
    }
    if (end == std::string::npos && parts.text.empty()) return std::nullopt;
    std::string line = parts.text.substr(0, end);
    parts.text.erase(0, std::min(end, parts.text.size() - 1) + 1);
    return line;
}

std::uint64_t storedBytes(const fs::path& path) {
    constexpr int kMaxParts = 10'000; // of a file that is full of holes
    const Descriptor file(openRetrying(path, O_RDONLY | O_NONBLOCK));
    struct stat status {};
    if (!file.valid() || ::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode)) return 0;
    off_t stored = 0, end = 0;
    for (int part = 0; part < kMaxParts; ++part) {
        const off_t begin = ::lseek(file.get(), end, SEEK_DATA);
        if (begin < 0) return static_cast<std::uint64_t>(errno == ENXIO ? stored : status.st_size);
        end = ::lseek(file.get(), begin, SEEK_HOLE);
        if (end < 0) break;
        stored += end - begin;
    }
    return static_cast<std::uint64_t>(end < 0 ? status.st_size : stored);
}

} // namespace rtcore
