/// PLY files of any kind, element by element: of text, or with lists of any number.
#pragma once

#include "rtcore/io/import/scan/ply_header.h"
#include "rtcore/platform/files.h"

#include <functional>
#include <span>
#include <vector>

namespace rtcore {

/// The values of an element by its properties: of a list the list alone, of others the number alone.
struct PlyRow {
    std::vector<double> numbers;
    std::vector<std::vector<double>> lists;
};

/// Calls `use` for each element of the file in its order, with what the head says of it. Elements of text are
/// a line each, of which what follows behind the last property is passed over. Memory follows the file's
/// bytes. `alive` is called now and then. Throws FileError BadData for a file that ends before its head says
/// or holds what is no number, what InputFile throws, and std::bad_alloc.
using UsePlyRow = std::function<void(const PlyElement& element, const PlyRow& row)>;
void readPlyRows(const InputFile& file, const PlyHeader& header, const std::function<void()>& alive,
                 const UsePlyRow& use);

} // namespace rtcore
