#include "spec/invalid_files.h"

#include "spec/invalid_maker.h"
#include "spec/valid_files.h"

namespace ravel::test {

InvalidMaker::InvalidMaker() {
    for (const ValidFile& file : valid_files()) {
        const auto parts = take_apart(file.bytes);
        if (!parts) throw std::runtime_error(file.name + " can't be taken apart");
        valid_[file.name] = put_together(*parts);
    }
}

std::vector<InvalidFile> invalid_files() {
    InvalidMaker maker;
    maker.container();
    maker.heads();
    maker.counts();
    maker.walks();
    maker.positions();
    maker.companions();
    maker.attributes();
    maker.orders();
    return maker.take();
}

}  // namespace ravel::test
