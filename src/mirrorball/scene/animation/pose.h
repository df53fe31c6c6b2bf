#pragma once

#include <cstddef>
#include <span>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// A scene as one of its animations shows it at a time: an ordinary scene, that all who draw take as it is. Nodes move
/// their meshes, cameras and lights; skins and morph targets bend meshes; and what the animation moves of materials,
/// lamps and cameras has its values of that time.
///
/// scene      at rest, as it was loaded, or stood upright since. What else is changed in a scene comes after its pose
/// animation  index into the animations of its rig
/// seconds    before the first key all is as there, and after the last as there
/// returns    a scene without animations, whose nodes are where they are then
/// errors     bad_file: a node's place is too large; bad_shape: bent meshes have other vertices since
/// cost       a copy of the scene, which a move spares; that of deform (deformation.h) for each mesh that is bent
Result<Scene> posed(Scene scene, std::size_t animation, double seconds);

/// The scene's parts at several times of an animation in one scene without a rig, such as a camera frames that is to
/// show all of it.
Result<Scene> posesTogether(Scene scene, std::size_t animation, std::span<const double> seconds);

/// Gives a scene the instances that its rig has at rest, and moves its cameras and lights there: the last that a reader
/// does, which has set all else of the scene and of the rig.
///
/// errors   bad_file: as posed's
Result<void> poseAtRest(Scene& scene);

/// Puts a node of a scene elsewhere in its parent, with all that is below it; skins that hang on it bend. What is
/// scaled to nothing is not shown: the scene has no instance of it then.
///
/// scene    gets what its rig says of all nodes: what was put elsewhere in another way is where its node is. Its own
///          meshes are copied where they bend; instances know nothing of each other (Instance::occlusion)
/// errors   usage (there is no such node); else as posed's, and then the scene is as before
/// cost     as poseAtRest's: proportional to the nodes, and deform of each mesh that is bent
Result<void> placeNode(Scene& scene, std::size_t node, const NodePlace& place);

/// Gives a scene that has no nodes one for each of its instances, cameras and lights, all without a parent.
void addNodes(Scene& scene);

}  // namespace mirrorball
