"""The glossy lobe as a Mitsuba plugin, "penumbra_lobe": Phong's lobe about the mirror and the refracted direction.

    f = F r (n + 2)/(2 pi) cos(alpha)^n      on the side of the viewer, alpha the angle to the mirror direction
    f = (1 - F) t (n + 2)/(2 pi) cos(beta)^n on the other side, beta the angle to the refracted direction

n exponent, r reflectance, t transmittance, F Fresnel's reflectance at the surface's own normal; F = 1 where t = 0.
"""

import drjit as dr
import mitsuba as mi


class Lobe(mi.BSDF):
    def __init__(self, props):
        mi.BSDF.__init__(self, props)
        self.exponent = props.get("exponent", 10.0)
        self.ior = props.get("ior", 1.0)
        self.reflectance = mi.Color3f(props.get("reflectance", mi.ScalarColor3f(0)))
        self.transmittance = mi.Color3f(props.get("transmittance", mi.ScalarColor3f(0)))
        self.opaque = max(self.transmittance) == 0
        sides = mi.BSDFFlags.FrontSide | mi.BSDFFlags.BackSide
        self.m_components = [mi.BSDFFlags.GlossyReflection | sides]
        if not self.opaque:
            self.m_components.append(mi.BSDFFlags.GlossyTransmission | sides)
        self.m_flags = self.m_components[0] | self.m_components[-1]

    def axes(self, wi):
        """The lobes' axes, and the colours that they carry."""
        mirror = mi.Vector3f(-wi.x, -wi.y, wi.z)
        if self.opaque:
            return mirror, self.reflectance, mirror, mi.Color3f(0)
        fresnel, cosine, _, ratio = mi.fresnel(wi.z, self.ior)
        return mirror, fresnel * self.reflectance, mi.refract(wi, cosine, ratio), (1 - fresnel) * self.transmittance

    def lobe(self, axis, wo, of_density):
        """cos^n about an axis; as a density, or as a reflectance."""
        cosine = dr.maximum(dr.dot(axis, wo), 0)
        return (self.exponent + (1 if of_density else 2)) / (2 * dr.pi) * dr.power(cosine, self.exponent)

    def chance(self, mirror_color, glass_color):
        """Of the mirror lobe to be sampled."""
        mirror, glass = dr.max(mirror_color), dr.max(glass_color)
        return dr.select(mirror + glass > 0, mirror / dr.maximum(mirror + glass, 1e-20), 1)

    def eval_pdf(self, ctx, si, wo, active=True):
        mirror, mirror_color, glass, glass_color = self.axes(si.wi)
        same_side = si.wi.z * wo.z > 0
        value, density = dr.select(same_side, mirror_color, 0) * self.lobe(mirror, wo, False), self.lobe(mirror, wo, True)
        if not self.opaque:
            chance = self.chance(mirror_color, glass_color)
            value += dr.select(same_side, 0, glass_color) * self.lobe(glass, wo, False)
            density = chance * density + (1 - chance) * self.lobe(glass, wo, True)
        return dr.select(active, value * dr.abs(wo.z), 0), dr.select(active, density, 0)

    def eval(self, ctx, si, wo, active=True):
        return self.eval_pdf(ctx, si, wo, active)[0]

    def pdf(self, ctx, si, wo, active=True):
        return self.eval_pdf(ctx, si, wo, active)[1]

    def sample(self, ctx, si, sample1, sample2, active=True):
        mirror, mirror_color, glass, glass_color = self.axes(si.wi)
        of_mirror = sample1 < self.chance(mirror_color, glass_color)
        cosine = dr.power(sample2.x, 1 / (self.exponent + 1))
        sine, (s, c) = dr.safe_sqrt(1 - cosine * cosine), dr.sincos(2 * dr.pi * sample2.y)
        wo = mi.Frame3f(dr.select(of_mirror, mirror, glass)).to_world(mi.Vector3f(sine * c, sine * s, cosine))
        value, density = self.eval_pdf(ctx, si, wo, active)

        sample = mi.BSDFSample3f()
        sample.wo, sample.pdf, sample.eta = wo, density, 1.0
        reflected = si.wi.z * wo.z > 0
        sample.sampled_type = dr.select(reflected, mi.UInt32(+mi.BSDFFlags.GlossyReflection), mi.UInt32(+mi.BSDFFlags.GlossyTransmission))
        sample.sampled_component = dr.select(reflected, mi.UInt32(0), mi.UInt32(len(self.m_components) - 1))
        return sample, dr.select(density > 0, value / dr.maximum(density, 1e-30), 0)

    def to_string(self):
        return f"Lobe[exponent={self.exponent}]"


def register():
    mi.register_bsdf("penumbra_lobe", lambda props: Lobe(props))
