// Tables of materials as programs write them.

#include "mirrorball/scene/mesh_file/mtl.h"

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "mirrorball/scene/mesh_file/mesh_file_testing.h"
#include "mirrorball/scene/mesh_file/obj.h"

namespace mirrorball {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

MtlMap parseMap(const std::string& statement) {
  std::vector<std::string> remarks;
  return readMtl("newmtl a\nmap_Kd " + statement + "\n", remarks).at(0).map(MtlMapKind::base_color);
}

TEST(Mtl, OptionsOfPicturesStandBeforeOrBehindTheirNames) {
  const MtlMap tiled = parseMap("-s 2 3 1 -o 0.25 -0.5 0 -clamp on -bm 0.5 tex one.png");
  EXPECT_THAT(tiled.readings, ElementsAre("tex one.png"));
  EXPECT_EQ(tiled.scale, glm::vec2(2, 3));
  EXPECT_EQ(tiled.offset, glm::vec2(0.25f, -0.5f));
  EXPECT_TRUE(tiled.is_clamped);
  EXPECT_EQ(tiled.strength, 0.5f);
  const MtlMap behind = parseMap("tex one.png -bm 2 -S 4 4 4");
  EXPECT_EQ(behind.readings.at(0), "tex one.png");
  EXPECT_EQ(behind.strength, 2.0f);
  EXPECT_EQ(behind.scale, glm::vec2(4));
  EXPECT_EQ(parseMap("-s 2 7.png").readings.at(0), "7.png") << "the last word is a name";
  EXPECT_EQ(parseMap("-s 2 7.png").scale, glm::vec2(2, 1));
  EXPECT_EQ(parseMap("-mm 0 1 -blendu off -boost 1 -texres 512 -imfchan m a.png").readings.at(0), "a.png");
  EXPECT_EQ(parseMap("-imfchan m a.png").channel, 'm');
  EXPECT_TRUE(parseMap("-mm 0.5 2 a.png").has_other_range);
  EXPECT_THAT(parseMap("wood #3.png").readings, ElementsAre("wood #3.png", "wood"));
  EXPECT_THAT(parseMap("\"my tex.png\"").readings, ElementsAre("my tex.png"));
  EXPECT_THAT(parseMap("").readings, IsEmpty());
  EXPECT_THAT(parseMap("-s 1 1 1").readings, Not(IsEmpty()));
}

/// A square with a material 'a' of a table, and the files beside it.
class MtlFolderTest : public testing::MeshFolderTest {
 protected:
  /// The model with that table, under a name with a blank.
  Scene load(const std::string& table, const std::string& usemtl = "a") const {
    write("my model.mtl", table);
    return loadNaming("my model.mtl", usemtl);
  }

  Scene loadNaming(const std::string& mtllib, const std::string& usemtl = "a") const {
    const std::string text = (mtllib.empty() ? "" : "mtllib " + mtllib + "\n") +
                             "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl " +
                             usemtl + "\nf 1/1 2/2 3/3 4/4\n";
    Result<Scene> scene = decodeObj(testing::toBytes(text), path("model.obj"));
    EXPECT_TRUE(scene) << scene.error().message;
    return scene ? std::move(*scene) : Scene();
  }

  Material material(const std::string& table) const { return load("newmtl a\n" + table).materials.at(0); }
};

// As Notepad and PowerShell write them.
TEST_F(MtlFolderTest, ATableMayBeInUtf16) {
  std::string table = "\xFF\xFE";
  for (const char letter : std::string("newmtl a\r\nKd 0.25 0.5 0.75\r\n")) table += {letter, '\0'};
  const Scene scene = load(table);
  EXPECT_EQ(scene.materials.at(0).base_color, glm::vec3(0.25f, 0.5f, 0.75f));
  EXPECT_THAT(scene.warnings, ElementsAre("'my model.mtl': is in UTF-16, and is read as the UTF-8 that it stands for"));
}

TEST_F(MtlFolderTest, WhatStandsInATablesPlaceIsNamed) {
  const Scene scene = load("version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n");
  EXPECT_THAT(
      scene.warnings,
      ::testing::Contains(HasSubstr("'my model.mtl' is a Git LFS pointer, which is not read; run `git lfs pull`")));
}

TEST_F(MtlFolderTest, NamesMayHaveBlanks) {
  writePicture("tex one.ppm", {255, 0, 0});
  const Scene scene = load("newmtl red paint\nKd 1 1 1\nmap_Kd tex one.ppm\n", "red paint");
  EXPECT_EQ(scene.materials.at(0).name, "red paint");
  EXPECT_THAT(scene.textures.at(0).image.samples(), ElementsAre(255, 0, 0, 255));
  EXPECT_THAT(scene.warnings, IsEmpty());
  EXPECT_EQ(load("newmtl a\nKd 0.25 0.5 0.75\n", "a # the only one").materials.at(0).base_color,
            glm::vec3(0.25f, 0.5f, 0.75f));
}

TEST_F(MtlFolderTest, ALineMayNameSeveralTables) {
  write("one.mtl", "newmtl b\nKd 0 1 0\n");
  write("two.mtl", "newmtl a\nKd 1 0 0\n");
  EXPECT_EQ(loadNaming("one.mtl two.mtl").materials.at(0).base_color, glm::vec3(1, 0, 0));
  const Scene scene = loadNaming("three.mtl two.mtl");
  EXPECT_EQ(scene.materials.at(0).base_color, glm::vec3(1, 0, 0));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("is missing")));
}

TEST_F(MtlFolderTest, ATableOfTheModelsNameStandsInForOneThatIsMissing) {
  write("model.mtl", "newmtl a\nKd 1 0 0\n");
  for (const std::string mtllib : {"", "renamed.mtl"}) {
    const Scene scene = loadNaming(mtllib);
    EXPECT_EQ(scene.materials.at(0).base_color, glm::vec3(1, 0, 0));
    EXPECT_THAT(scene.warnings, Contains(HasSubstr("'model.mtl'")));
  }
}

TEST_F(MtlFolderTest, NamesOfOtherMachinesLeadToWhatLiesBesideTheModel) {
  writePicture("Wood.PPM", {1, 2, 3});
  writePicture("Maps/Oak.ppm", {4, 5, 6});
  for (const std::string name : {"C:\\textures\\Wood.PPM", "/home/ann/wood.ppm", "wood.ppm", "no\\such\\WOOD.ppm"}) {
    const Scene scene = load("newmtl a\nmap_Kd " + name + "\n");
    EXPECT_THAT(scene.textures.at(0).image.samples(), ElementsAre(1, 2, 3, 255)) << name;
    EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("is read from 'Wood.PPM' in the model's folder"))) << name;
  }
  EXPECT_THAT(load("newmtl a\nmap_Kd maps\\oak.PPM\n").textures.at(0).image.samples(), ElementsAre(4, 5, 6, 255));
  EXPECT_THAT(load("newmtl a\nmap_Kd Maps\\Oak.ppm\n").warnings, IsEmpty());
  EXPECT_THAT(load("newmtl a\nmap_Kd C:\\none.ppm\n").warnings,
              ElementsAre(HasSubstr("put the file beside the model")));
}

// u' = s u + o where v grows upwards; a slot's v grows downwards.
TEST_F(MtlFolderTest, ScaleAndOffsetPlaceAPicture) {
  writePicture("a.ppm", {255, 0, 0, 0, 0, 255});
  const Scene scene = load("newmtl a\nKd 1 1 1\nmap_Kd -s 2 3 1 -o 0.25 0.5 0 a.ppm\n");
  const TextureSlot& slot = scene.materials.at(0).base_color_map;
  for (const glm::vec2 written : {glm::vec2(0, 0), glm::vec2(0.5f, 0.25f), glm::vec2(1, 1)}) {
    const glm::vec2 in_slot = uvMatrix(slot) * glm::vec2(written.x, 1.0f - written.y) + slot.offset;
    EXPECT_NEAR(in_slot.x, 2.0f * written.x + 0.25f, 1e-6f);
    EXPECT_NEAR(1.0f - in_slot.y, 3.0f * written.y + 0.5f, 1e-6f);
  }
  EXPECT_EQ(scene.textures.at(0).wrap_s, Wrap::repeat);
  const Scene clamped = load("newmtl a\nmap_Kd -clamp on a.ppm\n");
  EXPECT_EQ(clamped.textures.at(0).wrap_s, Wrap::clamp_to_edge);
  EXPECT_EQ(clamped.textures.at(0).wrap_t, Wrap::clamp_to_edge);
  EXPECT_EQ(clamped.materials.at(0).base_color_map.offset, glm::vec2(0));
}

TEST_F(MtlFolderTest, NumbersOfPhysicallyBasedMaterialsAreRead) {
  const Material a = material("Pr 0\nPm 0.75\nPs 0.25\nPc 0.5\nPcr 0.125\naniso 0.5\nanisor 0.25\nKe 3\n");
  EXPECT_EQ(a.perceptual_roughness, 0.0f);
  EXPECT_EQ(a.metallic, 0.75f);
  EXPECT_EQ(a.sheen_color, glm::vec3(0.25f));
  EXPECT_EQ(a.clearcoat, 0.5f);
  EXPECT_EQ(a.clearcoat_roughness, 0.125f);
  EXPECT_EQ(a.anisotropy, 0.5f);
  EXPECT_NEAR(a.anisotropy_rotation, std::numbers::pi_v<float> / 2.0f, 1e-6f);
  EXPECT_EQ(a.emission, glm::vec3(3)) << "one number is a grey";
}

TEST_F(MtlFolderTest, KeywordsAndLinesAreReadHoweverTheyAreWritten) {
  const Scene scene = load("\xEF\xBB\xBFNEWMTL a\r\n\tkd 0.5 0.25 \\\r\n 0.125\r\nNS 198\r\n");
  EXPECT_EQ(scene.materials.at(0).base_color, glm::vec3(0.5f, 0.25f, 0.125f));
  EXPECT_NEAR(scene.materials[0].perceptual_roughness, std::sqrt(0.1f), 1e-6f);
}

TEST_F(MtlFolderTest, ColoursThatAreOddAreToldOrLeftAlone) {
  EXPECT_EQ(material("Kd 0.5 nan 0\n").base_color, Material().base_color);
  EXPECT_EQ(material("Kd spectral ident.rfl\n").base_color, Material().base_color);
  const Scene codes = load("newmtl a\nKd 255 51 0\n");
  EXPECT_NEAR(codes.materials.at(0).base_color.g, 0.2f, 1e-6f);
  EXPECT_THAT(codes.warnings, ElementsAre(HasSubstr("has a Kd of 255, beyond 1: it is read in parts of 255")));
  const Scene rounded = load("newmtl a\nKd 1.000001 1 0.5\n");
  EXPECT_EQ(rounded.materials.at(0).base_color, glm::vec3(1, 1, 0.5f));
  EXPECT_THAT(rounded.warnings, IsEmpty());
  EXPECT_EQ(material("Kd 2 1 0\n").base_color, material("Kd 1 1 0\n").base_color) << "no codes: nearly black";
  const Scene bright = load("newmtl a\nKd 1.2 0.5 0\n");
  EXPECT_EQ(bright.materials.at(0).base_color, glm::vec3(1, 0.5f, 0));
  EXPECT_THAT(bright.warnings, ElementsAre(HasSubstr("has a Kd of 1.2, beyond 1: it is cut to 1")));
  const Scene negative = load("newmtl a\nKd -1 0.5 0\n");
  EXPECT_EQ(negative.materials.at(0).base_color, glm::vec3(0, 0.5f, 0));
  EXPECT_THAT(negative.warnings, ElementsAre(HasSubstr("has a Kd of -1, below 0: it is cut to 0")));
}

// Programs disagree whether Tr is 1 − d or d (three.js#12861); of MeshLab's old ones it is d (meshlab#1399).
TEST_F(MtlFolderTest, TransparencyIsOneMinusOpacityUnlessItHidesAll) {
  EXPECT_EQ(material("Tr 0.25\n").opacity, 0.75f);
  EXPECT_EQ(material("d 1\nTr 1\n").opacity, 1.0f) << "d counts";
  EXPECT_EQ(material("Tr 0\nd -halo 0.5\n").opacity, 0.5f);
  const Scene hidden = load("newmtl a\nTr 1.000000\n");
  EXPECT_EQ(hidden.materials.at(0).opacity, 1.0f);
  EXPECT_THAT(hidden.warnings, ElementsAre(HasSubstr("the material 'a' has a Tr of 1 and no d, by which nothing of it "
                                                     "is seen: it is read as opaque")));
}

// A model of which nothing is seen is none that anybody has made.
TEST_F(MtlFolderTest, MaterialsThatHideTheWholeModelAreOpaque) {
  for (const char* hides : {"d 0\n", "d 0.0\nTr 1\n", "d -1\n", "d 0\nTr 0\n"}) {
    const Scene hidden = load("newmtl a\n" + std::string(hides));
    EXPECT_EQ(hidden.materials.at(0).opacity, 1.0f) << hides;
    EXPECT_EQ(hidden.materials[0].alpha_mode, AlphaMode::opaque) << hides;
    EXPECT_THAT(hidden.warnings,
                ElementsAre(HasSubstr("all materials have a d of 0, by which nothing is seen: they are "
                                      "read as opaque")));
  }
  EXPECT_EQ(material("d 0.001\n").opacity, 0.001f);
}

TEST_F(MtlFolderTest, MaterialsThatHideAPartHideIt) {
  write("parts.mtl", "newmtl a\nd 0\nnewmtl b\nTr 1\nnewmtl c\nTr 1\n");
  const auto loadWith = [&](const std::string& others) {
    const std::string text = "mtllib parts.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n" + others + "usemtl a\nf 1 2 3\n";
    Result<Scene> scene = decodeObj(testing::toBytes(text), path("model.obj"));
    EXPECT_TRUE(scene) << scene.error().message;
    return std::move(*scene);
  };
  // Beside a face that names no material, whose material is the first; and beside two that are opaque.
  const Scene plain = loadWith("f 1 2 3\n");
  EXPECT_EQ(plain.materials.at(1).opacity, 0.0f);
  EXPECT_THAT(plain.warnings, IsEmpty());
  const Scene opaque = loadWith("usemtl b\nf 1 2 3\nusemtl c\nf 1 2 3\n");
  EXPECT_EQ(opaque.materials.at(0).opacity, 0.0f);
  EXPECT_EQ(opaque.materials.at(2).opacity, 1.0f);
  EXPECT_THAT(opaque.warnings, ElementsAre(HasSubstr("2 materials have a Tr of 1 and no d, by which nothing of them is "
                                                     "seen: they are read as opaque")));
}

TEST_F(MtlFolderTest, PicturesOfRoughnessAndMetalAreData) {
  writePicture("rough.ppm", {188, 188, 188});
  const Scene scene = load("newmtl a\nmap_Pr rough.ppm\nmap_Pm rough.ppm\nmap_ao rough.ppm\n");
  const Material& a = scene.materials.at(0);
  EXPECT_EQ(a.perceptual_roughness, 1.0f);
  EXPECT_EQ(a.metallic, 1.0f);
  ASSERT_GE(a.roughness_map.texture, 0);
  EXPECT_EQ(a.metallic_map.texture, a.roughness_map.texture);
  EXPECT_EQ(a.occlusion_map.texture, a.roughness_map.texture);
  EXPECT_FALSE(scene.textures.at(std::size_t(a.roughness_map.texture)).srgb);
  EXPECT_EQ(scene.textures[0].image.texel(0, 0)[1], 188);
}

TEST_F(MtlFolderTest, APictureOfOpacitiesIsTheAlphaOfTheColours) {
  writePicture("color.ppm", {10, 20, 30, 40, 50, 60});
  writePicture("mask.ppm", {255, 255, 255, 0, 0, 0});
  const Scene scene = load("newmtl a\nmap_Kd color.ppm\nmap_D mask.ppm\n");
  EXPECT_THAT(scene.textures.at(0).image.samples(), ElementsAre(10, 20, 30, 255, 40, 50, 60, 0));
  EXPECT_EQ(scene.materials.at(0).alpha_mode, AlphaMode::mask);
  writePicture("soft.ppm", {128, 128, 128});
  const Scene soft = load("newmtl a\nmap_Kd color.ppm\nmap_d soft.ppm\n");
  EXPECT_THAT(soft.textures.at(0).image.samples(), ElementsAre(10, 20, 30, 128, 40, 50, 60, 128));
  EXPECT_EQ(soft.materials.at(0).alpha_mode, AlphaMode::blend);
  const Scene alone = load("newmtl a\nKd 1 0 0\nmap_d mask.ppm\n");
  EXPECT_EQ(alone.materials.at(0).base_color, glm::vec3(1, 0, 0));
  EXPECT_THAT(alone.textures.at(0).image.samples(), ElementsAre(255, 255, 255, 255, 255, 255, 255, 0));
  const Scene twice = load("newmtl a\nmap_Kd color.ppm\nmap_d color.ppm\n");
  EXPECT_EQ(twice.materials.at(0).alpha_mode, AlphaMode::opaque) << "the picture has no alpha";
}

TEST_F(MtlFolderTest, AFinerPictureOfOpacitiesKeepsItsTexels) {
  writePicture("color.ppm", {10, 20, 30});
  writePicture("mask.ppm", {255, 255, 255, 0, 0, 0, 255, 255, 255});
  const Scene scene = load("newmtl a\nmap_Kd color.ppm\nmap_d mask.ppm\n");
  EXPECT_THAT(scene.textures.at(0).image.samples(), ElementsAre(10, 20, 30, 255, 10, 20, 30, 0, 10, 20, 30, 255));
  EXPECT_THAT(scene.warnings, IsEmpty());
  writePicture("two.ppm", {0, 0, 0, 200, 200, 200});
  writePicture("four.ppm", {255, 255, 255, 0, 0, 0, 255, 255, 255, 0, 0, 0});
  const Scene between = load("newmtl a\nmap_Kd two.ppm\nmap_d four.ppm\n");
  EXPECT_THAT(between.textures.at(0).image.samples(),
              ElementsAre(0, 0, 0, 255, 50, 50, 50, 0, 150, 150, 150, 255, 200, 200, 200, 0));
}

TEST_F(MtlFolderTest, OpacitiesLieWhereTheColoursDo) {
  writePicture("color.ppm", {10, 20, 30});
  writePicture("mask.ppm", {255, 255, 255});
  const Scene scene = load("newmtl a\nmap_Kd -s 2 2 1 color.ppm\nmap_d mask.ppm\n");
  EXPECT_EQ(scene.materials.at(0).base_color_map.scale, glm::vec2(2));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("'mask.ppm': is placed by other -s and -o than the colours")));
  EXPECT_THAT(load("newmtl a\nmap_Kd -s 2 2 1 color.ppm\nmap_d -s 2 2 1 mask.ppm\n").warnings, IsEmpty());
}

TEST_F(MtlFolderTest, OpacitiesStayWhereTheColoursCannotBeRead) {
  write("broken.png", "\x89PNG\r\n\x1a\nand no more");
  writePicture("mask.ppm", {255, 255, 255, 0, 0, 0});
  const Scene scene = load("newmtl a\nKd 1 0 0\nmap_Kd broken.png\nmap_d mask.ppm\n");
  EXPECT_THAT(scene.textures.at(0).image.samples(), ElementsAre(255, 255, 255, 255, 255, 255, 255, 0));
  EXPECT_EQ(scene.materials.at(0).alpha_mode, AlphaMode::mask);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("'broken.png'")));
}

TEST_F(MtlFolderTest, WhatIsOddInAPictureIsToldOnce) {
  write("broken.png", "\x89PNG\r\n\x1a\nand no more");
  const Scene scene = load("newmtl a\nmap_Kd broken.png\nmap_Pr broken.png\nmap_Ke broken.png\n");
  EXPECT_THAT(scene.warnings, SizeIs(1));
}

TEST_F(MtlFolderTest, BumpsAreHeightsUnlessTheyLookLikeNormals) {
  writePicture("heights.ppm", {0, 0, 0, 102, 102, 102, 204, 204, 204, 102, 102, 102});
  const Scene bumpy = load("newmtl a\nmap_Bump -bm 2 heights.ppm\n");
  const Texture& texture = bumpy.textures.at(std::size_t(bumpy.materials.at(0).normal_map.texture));
  ASSERT_TRUE(texture.image.hasNumbers());
  // The second texel: its neighbours are 0.8 apart, over two of four texels, and 1 is 0.02 widths high.
  const float slope = 0.02f * 0.8f / 0.5f;
  const glm::vec3 normal(texture.image.at(1, 0));
  EXPECT_NEAR(normal.x / normal.z, -slope, 1e-5f);
  EXPECT_NEAR(normal.y, 0.0f, 1e-6f);
  writePicture("normals.ppm", {128, 128, 255, 200, 128, 240});
  const Scene normals = load("newmtl a\nbump normals.ppm\n");
  EXPECT_EQ(normals.textures.at(0).image.texel(1, 0)[0], 200);
  EXPECT_THAT(normals.warnings, ElementsAre(HasSubstr("it is read as a normal map")));
  // Wood between black and a light grey.
  writePicture("wood.ppm", {0, 0, 0, 200, 70, 30, 204, 204, 204, 200, 70, 30});
  const Scene wood = load("newmtl a\nmap_Bump wood.ppm\n");
  const glm::vec3 of_wood(wood.textures.at(0).image.at(1, 0));
  EXPECT_NEAR(of_wood.x / of_wood.z, -0.01f * 0.8f / 0.5f, 1e-5f);
  const glm::vec3 beside(wood.textures[0].image.at(0, 0));
  EXPECT_NEAR(beside.x, 0.0f, 1e-6f);
  EXPECT_THAT(wood.warnings, ElementsAre(HasSubstr("its luma is read as heights")));
  const Scene named = load("newmtl a\nnorm -bm 0.5 normals.ppm\nbump heights.ppm\n");
  EXPECT_EQ(named.materials.at(0).normal_scale, 0.5f);
  EXPECT_THAT(named.warnings, ElementsAre(HasSubstr("'bump' is left out")));
}

TEST_F(MtlFolderTest, AMaterialGoesWithoutPicturesThatCannotBeRead) {
  write("broken.png", "\x89PNG\r\n\x1a\nand no more");
  for (const std::string name : {"broken.png", "none.png"}) {
    const Scene scene =
        load("newmtl a\nKd 0 0 0\nKe 1 1 1\nmap_Kd " + name + "\nmap_Ke " + name + "\nnorm " + name + "\n");
    const Material& a = scene.materials.at(0);
    EXPECT_THAT(scene.textures, IsEmpty());
    EXPECT_EQ(a.base_color_map.texture, -1);
    EXPECT_EQ(a.normal_map.texture, -1);
    EXPECT_NE(a.base_color, glm::vec3(0)) << "black stands beside a picture only";
    EXPECT_EQ(a.emission, glm::vec3(0)) << "where the picture glows is not known";
    EXPECT_THAT(scene.warnings, Each(HasSubstr("the material goes without it"))) << name;
  }
}

TEST_F(MtlFolderTest, WhatIsLeftOutIsToldOnceAStatement) {
  const Scene scene = load("newmtl a\nmap_Ks s.ppm\ndisp d.ppm\nrefl r.ppm\nmap_Ka\n");
  EXPECT_THAT(scene.warnings, SizeIs(3));
  EXPECT_THAT(scene.warnings, Each(HasSubstr("what 1 material says by '")));
}

TEST_F(MtlFolderTest, APictureOfAmbientColoursStandsInForOneOfDiffuseOnes) {
  writePicture("ambient.ppm", {1, 2, 3});
  EXPECT_THAT(load("newmtl a\nKa 1 1 1\nmap_Ka ambient.ppm\n").textures.at(0).image.samples(),
              ElementsAre(1, 2, 3, 255));
}

}  // namespace
}  // namespace mirrorball
