// Materials of an OBJ file, with what they name beside them.

#include <fstream>
#include <string_view>

#include "folder.h"
#include "mirrorball/scene/mesh_file/obj.h"
#include "model.h"

namespace {

constexpr std::string_view kTriangle =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 3/3 2/2 "
    "1/1\n";

/// A picture of one red pixel, as a.tga.
constexpr unsigned char kPicture[] = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 24, 0, 0, 0, 255};

}  // namespace

MIRRORBALL_HARNESS(mtl) {
  static const mirrorball::fuzz::Folder folder("mirrorball_mtl");
  std::ofstream(folder.path() / "a.tga").write(reinterpret_cast<const char*>(kPicture), sizeof(kPicture));
  std::ofstream(folder.path() / "a.mtl").write(reinterpret_cast<const char*>(data), std::streamsize(size));
  mirrorball::fuzz::checkModel(mirrorball::decodeObj(
      {reinterpret_cast<const std::uint8_t*>(kTriangle.data()), kTriangle.size()}, folder.path() / "a.obj"));
  return 0;
}
