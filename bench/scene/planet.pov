// A planet with mountains, one mesh of a million triangles: 1000 x 500 cells of two. Its functions are the parser's load, its
// triangles that of the tree; the benchmarks take the mesh from here.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -3> look_at 0 }
light_source { <-20, 30, -20> rgb 1 }

#declare Around = 1000;
#declare Rings = 500;
#declare Mountain = function(x, y, z, f) { sin(f * x + 1.3 * f) * sin(f * y + f) * sin(f * z + 0.7 * f) }
#declare Height = function {
  1 + Mountain(x, y, z, 3) / 10 + Mountain(x, y, z, 6) / 20 + Mountain(x, y, z, 12) / 40 + Mountain(x, y, z, 24) / 80
    + Mountain(x, y, z, 48) / 160 + Mountain(x, y, z, 96) / 320 + Mountain(x, y, z, 192) / 640
}

mesh2 {
  vertex_vectors {
    (Rings + 1) * Around
    #for (R, 0, Rings)
      #local Theta = pi * (R + 0.5) / (Rings + 1);
      #for (K, 0, Around - 1)
        #local P = <sin(Theta) * cos(2 * pi * K / Around), cos(Theta), sin(Theta) * sin(2 * pi * K / Around)>;
        Height(P.x, P.y, P.z) * P
      #end
    #end
  }
  face_indices {
    2 * Rings * Around
    #for (R, 0, Rings - 1)
      #local Here = R * Around;
      #for (K, 0, Around - 1)
        #local Next = mod(K + 1, Around);
        <Here + K, Here + Next, Here + Around + K>, <Here + Next, Here + Around + Next, Here + Around + K>
      #end
    #end
  }
  pigment { rgb <0.6, 0.5, 0.4> }
}
