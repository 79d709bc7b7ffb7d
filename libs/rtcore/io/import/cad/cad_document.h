/// A document of Open CASCADE, read from a file.
#pragma once

#include <TDocStd_Document.hxx>

#include <filesystem>
#include <functional>

namespace rtcore {

/// Shapes, names and colours; lengths in millimetres but of BREP. Throws FileError BadData with a message
/// without the name of the file. `alive` is called now and then.
Handle(TDocStd_Document)
    readCadDocument(const std::filesystem::path& path, const std::function<void()>& alive);

} // namespace rtcore
