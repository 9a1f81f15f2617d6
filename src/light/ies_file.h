#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/input_files.h"
#include "light/photometric_web.h"

namespace lapidary::light {

/// Reads the measurements of a luminaire from a file by ANSI/IES LM-63 of 1986 to 2019, of any type
/// of photometry. Candela are what the file's lamps give in its fixture: with its multiplier
/// and ballast factors. What the file says about tilted lamps is passed over: the lamp is taken to
/// burn as it did when it was measured.
///
/// `files`, if not null, notes that it was read. Throws Error, with the line, for files that cannot
/// be used.
PhotometricWeb read_ies(const std::filesystem::path& file, InputFiles* files = nullptr);
/// The same of a file's text; `file` is for messages.
PhotometricWeb parse_ies(std::string_view text, const std::string& file);

}  // namespace lapidary::light
