// Check cases of specification chapter 11 §16 that show in the description.
#include "tests/parser/statement/scene_text.hpp"

namespace lute::test {
namespace {

TEST(Objects, EveryPrimitiveIsRead) {
  const Scene scene = scene_of(kVersion + R"(
    sphere { 0, 1 } box { -1, 1 } plane { y, 0 } cylinder { 0, y, 1 open } cone { 0, 1, y, 0.5 } disc { 0, y, 1, 0.5 }
    torus { 1, 0.25 sturm } triangle { 0, x, y } smooth_triangle { 0, z, x, z, y, z } mesh { triangle { 0, x, y } }
    blob { threshold 0.5 sphere { 0, 1, 1 } cylinder { 0, y, 1, strength 2 } sturm hierarchy off }
    ovus { 1, 0.5 } superellipsoid { <0.5, 0.5> } quadric { 1, 0, 0, -1 } poly { 2, <1,0,0,0,1,0,0,1,0,-1> }
    polynomial { 3, xyz(3,0,0): 1, xyz(0,0,0): -1 } lathe { linear_spline 2, <1, 0>, <1, 1> }
    sor { 4, <0, -1>, <1, 0>, <1, 1>, <0, 2> } prism { 0, 1, 4, <0,0>, <1,0>, <1,1>, <0,0> }
    sphere_sweep { linear_spline 2, 0, 1, y, 0.5 } polygon { 4, 0, x, y, 0 } julia_fractal { <-0.1, 0, -0.8, 0> }
    isosurface { function { x*x + y*y + z*z - 1 } max_gradient 4 }
    text { ttf "timrom.ttf" "A", 1, 0 }
  )");
  EXPECT_EQ(scene.objects.size(), 24u);
}

TEST(Objects, IdentifierAfterAnyKeywordStartsFromThatObject) {
  const Scene scene = scene_of(kVersion + "#declare B = box { 0, 1 } sphere { B translate x }");
  EXPECT_TRUE(only_object(scene).shape_if<Box>() != nullptr);
  EXPECT_EQ(only_object(scene).transform->translation, dvec3(1, 0, 0));
}

TEST(Objects, BareIdentifiersStandOnlyBehindTheFirstMember) {
  const std::string declare = kVersion + "#declare A = sphere { 0, 1 } #declare B = box { 0, 1 }\n";
  EXPECT_EQ(rejection_of(declare + "union { A B }"), "No matching } in 'union', object identifier found instead");
  EXPECT_EQ(rejection_of(declare + "union { object { A } B }"), "");
  EXPECT_EQ(rejection_of(declare + "B"), "");
}

TEST(Objects, ErrorsOfCase27) {
  EXPECT_EQ(rejection_of(kVersion + "box { -1, 1 pigment { rgb 1 } uv_mapping }"), "uv_mapping must be specified before texture.");
  EXPECT_THAT(rejection_of(kVersion + "box { -1, 1 no_shadow off }"), testing::HasSubstr("No matching } in 'box'"));
  EXPECT_EQ(rejection_of(kVersion + "light_source { 0 1 radius 9 spotlight }"),
            "Keyword 'radius' cannot be used with standard light source.");
  EXPECT_EQ(rejection_of(kVersion + "sky_sphere { }"), "Empty sky_sphere statement.");
}

TEST(Objects, TransformationsCarryTheTexturesWrittenBefore) {
  const Scene scene = scene_of(kVersion + "sphere { 0, 1 pigment { gradient x } translate x normal { bumps 1 } }");
  const Object& sphere = only_object(scene);
  // The placement went into the pigment when the normal was added; the normal itself was not moved.
  EXPECT_TRUE(sphere.texture.placement.identity());
  ASSERT_EQ(layer(sphere, 0).pigment->body.warps.size(), 1u);
  EXPECT_EQ(std::get<Transform>(layer(sphere, 0).pigment->body.warps[0]).translation, dvec3(1, 0, 0));
  EXPECT_TRUE(layer(sphere, 0).normal->body.warps.empty());
}

TEST(Objects, TransformationsBeforeTheFirstTextureItemCarryNothing) {
  const Scene scene = scene_of(kVersion + "#default { pigment { gradient y } } box { -1, 1 scale 5 finish { diffuse 1 } pigment { gradient x } }");
  EXPECT_TRUE(only_object(scene).texture.placement.identity());
  EXPECT_TRUE(layer(only_object(scene), 0).pigment->body.warps.empty());
  const Scene by_default = scene_of(kVersion + "#default { pigment { gradient y } } box { -1, 1 scale 5 finish { diffuse 1 } }");
  EXPECT_TRUE(layer(only_object(by_default), 0).pigment->body.warps.empty());
}

TEST(Objects, UvMappedTexturesStayWhenTheObjectMoves) {
  const Scene scene = scene_of(kVersion + "sphere { 0, 1 uv_mapping pigment { gradient x } translate x }");
  EXPECT_TRUE(only_object(scene).texture.placement.identity());
}

TEST(Objects, PigmentOnAnObjectChangesTheTopLayer) {  // case 1
  const Scene scene = scene_of(
      kVersion + "plane { z, 0 texture { pigment { rgb x } } texture { pigment { rgbt <0, 1, 0, .5> } } pigment { rgbt <0, 0, 1, .5> } }");
  const Object& plane = only_object(scene);
  ASSERT_EQ(layer_count(plane), 2u);
  EXPECT_EQ(plain_color(*layer(plane, 0).pigment).rgb, Rgb(1, 0, 0));
  EXPECT_EQ(plain_color(*layer(plane, 1).pigment).rgb, Rgb(0, 0, 1));
}

TEST(Objects, TextureIdentifiersMoveAllTheirLayers) {  // case 2
  const Scene scene = scene_of(kVersion + R"(#declare T = texture { pigment { gradient x scale 4 } } texture { pigment { rgbt <0, 1, 0, .5> } }
    box { 0, 1 texture { T translate x } })");
  ASSERT_EQ(layer_count(only_object(scene)), 2u);
  const auto& chain = layer(only_object(scene), 0).pigment->body.warps;
  ASSERT_EQ(chain.size(), 1u);
  EXPECT_EQ(std::get<Transform>(chain[0]).point(dvec3(1, 0, 0)), dvec3(5, 0, 0));
}

TEST(Objects, MaterialTransformationMovesTheTexturesPresent) {  // case 11
  const Scene scene = scene_of(kVersion + "box { 0, 1 pigment { gradient x scale 4 } material { translate x } }");
  EXPECT_EQ(only_object(scene).texture.placement->translation, dvec3(1, 0, 0));
  EXPECT_TRUE(only_object(scene).transform.identity());
}

TEST(Objects, InverseInATransformBlockInvertsTheWhole) {  // case 12
  const Scene scene = scene_of(kVersion + "box { 0, 1 transform { translate x scale 2 inverse } }");
  EXPECT_EQ(only_object(scene).transform->point(dvec3(2, 0, 0)), dvec3(0, 0, 0));
}

TEST(Objects, InteriorsOfOneObjectAreEditedAndTheirMediaAccumulate) {  // case 21
  const Scene scene =
      scene_of(kVersion + "box { 0, 1 interior { ior 1.5 media { emission .2 } } interior { media { emission .2 } } hollow }");
  ASSERT_NE(only_object(scene).extras->interior, nullptr);
  EXPECT_EQ(only_object(scene).extras->interior->media.size(), 2u);
  EXPECT_FLOAT_EQ(only_object(scene).extras->interior->ior, 1.5f);
  EXPECT_EQ(only_object(scene).hollow, true);
}

TEST(Objects, UntexturedObjectsTakeTheDefaultOfTheirUse) {  // case 10
  const Scene scene = scene_of(kVersion + "#declare S = box { 0, 1 } #default { pigment { rgb y } } object { S }");
  EXPECT_EQ(only_object(scene).texture.texture, nullptr);
  const auto& layers = std::get<std::vector<TextureLayer>>(only_object(scene).extras->default_texture->content);
  EXPECT_EQ(plain_color(*layers.at(0).pigment).rgb, Rgb(0, 1, 0));
}

TEST(Objects, ClipsMustBePlainSolids) {
  const std::string message = "Illegal texture or patch in clip, bound or object pattern.";
  EXPECT_EQ(rejection_of(kVersion + "sphere { 0, 1 clipped_by { box { 0, 1 pigment { rgb 1 } } } }"), message);
  EXPECT_EQ(rejection_of(kVersion + "sphere { 0, 1 clipped_by { triangle { 0, x, y } } }"), message);
}

TEST(Objects, ClipsMoveWithTheirObject) {
  const Scene scene = scene_of(kVersion + "sphere { 0, 1 clipped_by { plane { y, 0 } } bounded_by { clipped_by } translate y }");
  const Object& sphere = only_object(scene);
  ASSERT_EQ(sphere.extras->clipped_by.size(), 1u);
  EXPECT_EQ(sphere.extras->clipped_by[0]->transform->translation, dvec3(0, 1, 0));
  EXPECT_EQ(sphere.extras->bounded_by, sphere.extras->clipped_by);
}

TEST(Objects, ModifiersOfOtherObjectsAreErrors) {
  EXPECT_EQ(rejection_of(kVersion + "sphere { 0, 1 sturm }"), "Keyword 'sturm' cannot be used with this object.");
  EXPECT_EQ(rejection_of(kVersion + "sphere { 0, 1 split_union off }"), "split_union found in non-union object.");
  EXPECT_EQ(rejection_of(kVersion + "union { sphere { 0, 1 } sphere { 0, 2 } cutaway_textures }"),
            "cutaway_textures can only be used with intersection and difference.");
  // `inverse` makes an intersection of a union (§7.1).
  EXPECT_EQ(rejection_of(kVersion + "union { sphere { 0, 1 } sphere { 0, 2 } inverse cutaway_textures }"), "");
}

TEST(Objects, ScaleByZeroIsReplaced) {
  EXPECT_TRUE(warns(kVersion + "sphere { 0, 1 scale <1, 0, 1> }", "Illegal Value: Scale Y by 0.0. Changed to 1.0."));
}

TEST(Objects, LayersOverPatternedTexturesAreErrors) {
  const std::string patterned = "texture { checker texture { pigment { rgb 1 } } }";
  EXPECT_EQ(rejection_of(kVersion + "box { 0, 1 " + patterned + " texture { pigment { rgb 1 } } }"),
            "Cannot layer over a patterned texture.");
  EXPECT_EQ(rejection_of(kVersion + "box { 0, 1 texture { pigment { rgb 1 } } " + patterned + "}"),
            "Cannot layer a patterned texture over another.");
}

TEST(Objects, MeshKeepsFlatWhatHasEqualNormals) {  // chapter 21 §3.2
  const Scene scene = scene_of(
      kVersion + "mesh { smooth_triangle { 0, z, x, z, y, z } smooth_triangle { 0, z, x, x + z, y, z } triangle { 0, 0, 0 } }");
  const MeshData& mesh = *only_object(scene).shape_if<Mesh>()->data;
  ASSERT_EQ(mesh.faces.size(), 2u);  // the degenerate one is dropped
  EXPECT_EQ(mesh.normal_indices.at(0)[0], MeshData::kNone);
  EXPECT_NE(mesh.normal_indices.at(1)[0], MeshData::kNone);
  EXPECT_EQ(mesh.vertices.size(), 3u);
  // (p3 - p1) x (p2 - p1) = y x x = -z
  EXPECT_EQ(mesh.face_normals.at(0), glm::vec3(0, 0, -1));
}

TEST(Objects, Mesh2FacesMayHaveThreeTextures) {  // case 28
  const Scene scene = scene_of(kVersion + R"(mesh2 { vertex_vectors { 3, <-2,-2,0>, <2,-2,0>, <0,9,0> }
    texture_list { 3, texture { pigment { rgb x } }, texture { pigment { rgb y } }, texture { pigment { rgb z } } }
    face_indices { 1, <0,1,2>, 0, 1, 2 } })");
  const MeshData& mesh = *only_object(scene).shape_if<Mesh>()->data;
  EXPECT_EQ(mesh.textures.size(), 3u);
  EXPECT_EQ(mesh.texture_indices.at(0), (MeshData::Indices{0, 1, 2}));
}

TEST(Objects, Mesh2ChecksItsIndices) {
  const std::string head = kVersion + "mesh2 { vertex_vectors { 3, 0, x, y } ";
  EXPECT_EQ(rejection_of(head + "face_indices { 1, <0, 1, 3> } }"), "Mesh face index out of range.");
  EXPECT_EQ(rejection_of(head + "face_indices { 0 } }"), "No triangles in triangle mesh.");
  EXPECT_EQ(rejection_of(kVersion + "mesh2 { face_indices { 1, <0, 1, 2> } }"), "Vertex vectors not found in mesh2");
}

}  // namespace
}  // namespace lute::test
