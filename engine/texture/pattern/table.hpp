// The table of patterns: one line each.
#pragma once

#include <variant>

#include "engine/texture/pattern/agate.hpp"
#include "engine/texture/pattern/aoi.hpp"
#include "engine/texture/pattern/boxed.hpp"
#include "engine/texture/pattern/bozo.hpp"
#include "engine/texture/pattern/brick.hpp"
#include "engine/texture/pattern/bump_map.hpp"
#include "engine/texture/pattern/bumps.hpp"
#include "engine/texture/pattern/cells.hpp"
#include "engine/texture/pattern/checker.hpp"
#include "engine/texture/pattern/crackle.hpp"
#include "engine/texture/pattern/cubic.hpp"
#include "engine/texture/pattern/cylindrical.hpp"
#include "engine/texture/pattern/density_file.hpp"
#include "engine/texture/pattern/dents.hpp"
#include "engine/texture/pattern/facets.hpp"
#include "engine/texture/pattern/function_pattern.hpp"
#include "engine/texture/pattern/gradient.hpp"
#include "engine/texture/pattern/granite.hpp"
#include "engine/texture/pattern/hexagon.hpp"
#include "engine/texture/pattern/image_map.hpp"
#include "engine/texture/pattern/image_pattern.hpp"
#include "engine/texture/pattern/julia.hpp"
#include "engine/texture/pattern/leopard.hpp"
#include "engine/texture/pattern/magnet.hpp"
#include "engine/texture/pattern/mandel.hpp"
#include "engine/texture/pattern/marble.hpp"
#include "engine/texture/pattern/material_map.hpp"
#include "engine/texture/pattern/object_pattern.hpp"
#include "engine/texture/pattern/onion.hpp"
#include "engine/texture/pattern/pavement.hpp"
#include "engine/texture/pattern/pigment_pattern.hpp"
#include "engine/texture/pattern/planar.hpp"
#include "engine/texture/pattern/quilted.hpp"
#include "engine/texture/pattern/radial.hpp"
#include "engine/texture/pattern/ripples.hpp"
#include "engine/texture/pattern/slope.hpp"
#include "engine/texture/pattern/spherical.hpp"
#include "engine/texture/pattern/spiral1.hpp"
#include "engine/texture/pattern/spiral2.hpp"
#include "engine/texture/pattern/spotted.hpp"
#include "engine/texture/pattern/square.hpp"
#include "engine/texture/pattern/tiling.hpp"
#include "engine/texture/pattern/triangular.hpp"
#include "engine/texture/pattern/waves.hpp"
#include "engine/texture/pattern/wood.hpp"
#include "engine/texture/pattern/wrinkles.hpp"

namespace lute {

using AnyPattern = std::variant<  //
    Agate,                        //
    Aoi,                          //
    Boxed,                        //
    Bozo,                         //
    Brick,                        //
    BumpMap,                      //
    Bumps,                        //
    Cells,                        //
    Checker,                      //
    Crackle,                      //
    Cubic,                        //
    Cylindrical,                  //
    DensityFile,                  //
    Dents,                        //
    Facets,                       //
    FunctionPattern,              //
    Gradient,                     //
    Granite,                      //
    Hexagon,                      //
    ImageMap,                     //
    ImagePattern,                 //
    Julia,                        //
    Leopard,                      //
    Magnet,                       //
    Mandel,                       //
    Marble,                       //
    MaterialMap,                  //
    ObjectPattern,                //
    Onion,                        //
    Pavement,                     //
    PigmentPattern,               //
    Planar,                       //
    Quilted,                      //
    Radial,                       //
    Ripples,                      //
    Slope,                        //
    Spherical,                    //
    Spiral1,                      //
    Spiral2,                      //
    Spotted,                      //
    Square,                       //
    Tiling,                       //
    Triangular,                   //
    Waves,                        //
    Wood,                         //
    Wrinkles>;

}  // namespace lute
