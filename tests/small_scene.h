#pragma once

#include <string>

/// A scene with every key once.
inline const std::string small_scene = R"(title = "everything once"
ambient = 0.25
environment = [0.1, 0.2, 0.3]
background = [0.4, 0.5, 0.6]

[render]
samples = 7
bounces = 2
depth = 3
sampler = "stratified"
exposure = 0.5

[camera]
eye = [0, 0, 5]
target = [0, 0, 1]
up = [0, 2, 0]
vfov = 90
size = [30, 20]
lens_radius = 0.125
focus = inf

[shutter]
open = -1
close = 2.5

[materials.all]
ambient = 0.1
albedo = [0.2, 0.3, 0.4]
specular = 0.5
shininess = 20
reflectance = 0.6
transmittance = 0.7
exponent = 50
ior = 1.5
emission = 8
sampled = false
checker = { albedo = [0, 0.5, 1], size = 0.25 }
medium = { extinction = 3, albedo = [0.9, 0.8, 0.7], g = -0.5 }

[[light]]
type = "point"
position = [1, 2, 3]
intensity = [4, 5, 6]

[[light]]
type = "directional"
toward = [0, 10, 0]
irradiance = 2

[[shape]]
type = "sphere"
center = [1, 2, 3]
radius = 0.5
material = "all"
velocity = [1, 0, -1]

[[shape]]
type = "triangle"
a = [0, 0, 0]
b = [1, 0, 0]
c = [0, 1, 0]
material = "all"

[[shape]]
type = "quad"
center = [0, 1, 0]
u = [2, 0, 0]
v = [0, 0, -3]
material = "all"

[[shape]]
type = "disc"
center = [0, 3, 0]
normal = [0, -4, 0]
radius = 2
material = "all"
)";
