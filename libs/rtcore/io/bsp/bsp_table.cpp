#include "rtcore/io/bsp/bsp_table.h"

#include "rtcore/io/bsp/bsp_checksum.h"
#include "rtcore/io/bsp/bsp_version2.h"
#include "rtcore/io/bsp/model_check.h"
#include "rtcore/platform/error.h"

#include <algorithm>
#include <cstring>

namespace rtcore {

namespace {

using Bytes = std::span<const std::byte>;

std::string_view nameOf(const BspSectionEntry& entry) {
    const auto end = std::find(entry.name.begin(), entry.name.end(), '\0');
    return {entry.name.data(), static_cast<std::size_t>(end - entry.name.begin())};
}

/// For messages: a name that we do not know may hold anything.
Sentence shownNameOf(const BspSectionEntry& entry) {
    for (const BspSectionKind& kind : kBspSectionKinds) {
        if (kind.name == nameOf(entry)) return kind.name;
    }
    return form("of an unknown name");
}

BspSectionEntry entryOf(BspSection section, const BspSectionEntry2& old) {
    BspSectionEntry entry{};
    const std::string_view name = kindOf(section).name;
    std::copy(name.begin(), name.end(), entry.name.begin());
    entry.elementSize = kindOf(section).minSize;
    entry.offset = old.offset;
    entry.count = old.count;
    return entry;
}

class TableReader {
  public:
    TableReader(Bytes bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    BspTable read() {
        readCommon();
        const std::uint64_t end = head_.version == 2 ? readVersion2() : readNamedSections();
        table_.version = head_.version;
        table_.identity = {head_.sourceSize, head_.sourceCrc, head_.buildOptionsHash};
        table_.hasTree = head_.hasTree == 1;
        checkSections(end);
        checkNames();
        table_.bounds = boundsOf();
        checkPayload(); // reads all of the file, and so comes last
        return std::move(table_);
    }

  private:
    void expect(bool condition, const char* otherwise) const {
        if (!condition) failBsp(name_, otherwise);
    }
    /// `problem` is a form with a place for the name of the section.
    [[noreturn]] void failSection(const BspSectionEntry& entry, const char* problem) const {
        failBsp(name_, say(problem, shownNameOf(entry)));
    }

    /// The fields that every version begins with.
    void readCommon() {
        expect(isBsp(bytes_), form("is no .bsp file of this suite (other programs use the same ending)"));
        expect(bytes_.size() >= sizeof(BspHead), form("header: the file is cut off"));
        std::memcpy(&head_, bytes_.data(), sizeof head_);
        expect(head_.byteOrder == kBspByteOrder,
               form("header: written by a machine of the other byte order"));
        expect(head_.version >= 2 && head_.version <= kBspVersion,
               form("header: written by another version of BSPBuilder"));
    }

    /// The end of the head and of the table.
    std::uint64_t readNamedSections() {
        expect(head_.headSize == sizeof(BspHead) && head_.sectionCount <= kMaxBspSections,
               form("header: of the wrong size"));
        checkHead(head_.headCrc);
        expect(head_.reserved == decltype(head_.reserved){},
               form("header: its reserved fields are not zero"));
        const std::uint64_t end = sizeof(BspHead) + head_.sectionCount * sizeof(BspSectionEntry);
        expect(end <= bytes_.size(), form("the table of sections is cut off"));
        table_.sections.resize(head_.sectionCount);
        if (!table_.sections.empty())
            std::memcpy(table_.sections.data(), bytes_.data() + sizeof(BspHead), end - sizeof(BspHead));
        return end;
    }

    std::uint64_t readVersion2() {
        BspHead2 head{};
        expect(bytes_.size() >= sizeof head, form("header: the file is cut off"));
        std::memcpy(&head, bytes_.data(), sizeof head);
        expect(head.headSize == sizeof head && head.sectionCount == head.sections.size(),
               form("header: of the wrong size"));
        checkHead(head.headCrc);
        expect(head.reserved == decltype(head.reserved){}, form("header: its reserved fields are not zero"));
        for (std::size_t i = 0; i < head.sections.size(); ++i) {
            table_.sections.push_back(entryOf(kBspSectionsOfVersion2[i], head.sections[i]));
            if (head.sections[i].elementSize != table_.sections.back().elementSize)
                failSection(table_.sections.back(), form("section {0} has elements of the wrong size"));
        }
        return sizeof head;
    }

    void checkHead(std::uint32_t crc) const {
        expect(crc == crc32Of(bytes_.first(head_.headSize - sizeof crc)),
               form("header: damaged (its checksum differs)"));
        expect(head_.fileSize >= bytes_.size(), form("the file is longer than it should be"));
        expect(head_.fileSize <= bytes_.size(), form("the file is cut off"));
        expect(head_.hasTree <= 1, form("header: its flags make no sense"));
    }

    void checkPayload() const {
        expect(crc32Of(bytes_.subspan(head_.headSize)) == head_.payloadCrc,
               form("the sections are damaged (their checksum differs)"));
    }

    /// Each section begins at the next multiple of 64 behind the one before and the last ends the file, so
    /// that none overlap and no byte is left over.
    void checkSections(std::uint64_t end) const {
        const std::uint64_t size = bytes_.size();
        for (const BspSectionEntry& entry : table_.sections) {
            const std::uint64_t begin = (end + kBspAlignment - 1) / kBspAlignment * kBspAlignment;
            if (entry.elementSize == 0)
                failSection(entry, form("section {0} has elements of the wrong size"));
            if (entry.offset != begin || begin > size)
                failSection(entry, form("section {0} begins at the wrong place"));
            if (entry.count > (size - begin) / entry.elementSize)
                failSection(entry, form("section {0} ends behind the end of the file"));
            const Bytes gap = bytes_.subspan(end, begin - end);
            if (std::any_of(gap.begin(), gap.end(), [](std::byte b) { return b != std::byte{0}; }))
                failSection(entry, form("section {0} has bytes before it that are not zero"));
            end = begin + entry.count * entry.elementSize;
        }
        expect(end == size, form("the last section does not end with the file"));
    }

    void checkNames() const {
        std::vector<std::string_view> names;
        for (const BspSectionEntry& entry : table_.sections) {
            const std::string_view name = nameOf(entry);
            const auto* behind = entry.name.data() + name.size();
            if (name.empty() ||
                std::any_of(behind, entry.name.data() + entry.name.size(), [](char c) { return c != 0; }))
                failBsp(name_, form("a section has no proper name"));
            names.push_back(name);
        }
        std::sort(names.begin(), names.end());
        expect(std::adjacent_find(names.begin(), names.end()) == names.end(),
               form("two sections have the same name"));
    }

    Box3 boundsOf() const {
        const auto& lo = head_.boundsLo;
        const auto& hi = head_.boundsHi;
        const Box3 bounds{{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}};
        if (bounds == Box3{}) return bounds;
        // A builder may widen the box by a few units in the last place.
        constexpr float max = kLargestNumber * 1.001F;
        for (int a = 0; a < 3; ++a) {
            expect(bounds.lo[a] >= -max && bounds.lo[a] <= bounds.hi[a] && bounds.hi[a] <= max,
                   form("header: the bounds are no box"));
        }
        return bounds;
    }

    Bytes bytes_;
    const std::string& name_;
    BspHead head_{};
    BspTable table_;
};

} // namespace

const BspSectionEntry* BspTable::find(BspSection section) const {
    const auto at = std::find_if(sections.begin(), sections.end(), [&](const BspSectionEntry& entry) {
        return nameOf(entry) == kindOf(section).name;
    });
    return at != sections.end() ? &*at : nullptr;
}

BspTable readBspTable(std::span<const std::byte> bytes, const std::string& name) {
    return TableReader(bytes, name).read();
}

void failBsp(const std::string& name, const Sentence& problem) {
    throw FileError(FailureKind::BadData, name, say("{0}; build it again with BSPBuilder", problem));
}

bool isBsp(std::span<const std::byte> head) {
    return head.size() >= kBspMagic.size() &&
           std::memcmp(head.data(), kBspMagic.data(), kBspMagic.size()) == 0;
}

} // namespace rtcore
