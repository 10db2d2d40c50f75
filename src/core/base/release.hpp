// Objects of C libraries as owned values: std::unique_ptr<FcConfig, Release<FcConfigDestroy>>.
#pragma once

namespace gaspard {

template <auto release>
struct Release {
    template <class T>
    void operator()(T* object) const {
        release(object);
    }
};

} // namespace gaspard
