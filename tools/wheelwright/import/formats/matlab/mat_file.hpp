// MATLAB files as recordings: level 5 (save -v6, -v7; Octave's -v6 and -v7) and level 4.
// Specification: MathWorks, "MAT-File Format" (R2024a).
//
// Vectors of equal length, at the top or in structs, make a stream; a matrix of N rows and few columns
// gives the channels "name(:,1)", "name(:,2)" ...; fields of structs are "data.left"; scalars and short texts
// go to the metadata. What is not read (cells, objects such as a timeseries, complex and sparse arrays) is
// named in a remark with the mend.
#pragma once

#include <string>
#include <string_view>

#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// Level 4 has no magic number: it is known by a header whose every field is in its range.
bool is_mat_file(std::string_view head);

// `bytes`: the whole file; `name` stands for it in messages. What lies before a cut is read. Refuses level
// 7.3, which is HDF5, with the mend.
ReadResult read_mat_file(std::string_view bytes, const std::string& name);

}  // namespace wheelwright::import
