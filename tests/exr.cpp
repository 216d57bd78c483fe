#include "exr.h"

#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfStringAttribute.h>

namespace rt {

Image read_exr(const std::string& path) {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i window = file.header().dataWindow();
    Image image(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1);
    std::vector<float> samples(image.pixels.size() * 3);
    Imf::FrameBuffer buffer;
    for (std::size_t i = 0; i < 3; ++i)
        buffer.insert(std::string(1, "RGB"[i]),
                      Imf::Slice::Make(Imf::FLOAT, samples.data() + i, window, 3 * sizeof(float)));
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = {samples[3 * i], samples[3 * i + 1], samples[3 * i + 2]};
    return image;
}

Label read_label(const std::string& path) {
    const Imf::InputFile file(path.c_str());
    const Imf::Header& header = file.header();
    const Imath::Box2i &display = header.displayWindow(), &data = header.dataWindow();
    Label label{{data.min.x - display.min.x, data.min.y - display.min.y},
                {display.max.x - display.min.x + 1, display.max.y - display.min.y + 1}};
    for (auto it = header.begin(); it != header.end(); ++it) {
        if (const auto* number = dynamic_cast<const Imf::IntAttribute*>(&it.attribute()))
            label.attributes.emplace_back(it.name(), number->value());
        if (const auto* number = dynamic_cast<const Imf::DoubleAttribute*>(&it.attribute()))
            label.attributes.emplace_back(it.name(), number->value());
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute()))
            label.attributes.emplace_back(it.name(), text->value());
    }
    return label;
}

}  // namespace rt
