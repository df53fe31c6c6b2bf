#pragma once

#include <filesystem>

#include "mirrorball/base/descriptor.h"
#include "mirrorball/base/result.h"
#include "mirrorball/base/unfinished.h"

namespace mirrorball {

/// A file under a temporary name, `.mirrorball-` and random digits and `.part`, that is to get its own name later. Its
/// length does not depend on that name, which may so be as long as file systems allow.
///
/// A run that is killed leaves its part behind. Whoever makes a part in a folder also removes what others left there;
/// that a part is in use is known by a lock (flock), which the kernel takes away from a process however that ends.
/// Parts of processes that run at the same time are thereby safe: a part is removed only by who holds its lock, and one
/// that was removed between its making and its locking is seen to have no name any more, and is made again. Where our
/// own lock does not keep us out, as in file systems without any, nothing is removed.
struct PartFile {
  Descriptor file;      ///< open for reading and writing; locked until it is closed
  UnfinishedPath path;  ///< goes away before the lock does
};

/// Makes a part that did not exist before: what others have put under its name is neither followed nor written to.
///
/// folder   empty: the current one
/// errors   io: the reason alone, as in "Permission denied"
/// cost     that of listing the folder
Result<PartFile> makePart(const std::filesystem::path& folder);

/// Makes a part without a name, which the kernel removes however the process ends. Where the file system cannot make
/// such files it has a name for a moment.
///
/// errors   as makePart's
Result<PartFile> makeUnnamedPart(const std::filesystem::path& folder);

/// Whether a file's name is that of a part.
bool isPartName(const std::filesystem::path& name);

}  // namespace mirrorball
