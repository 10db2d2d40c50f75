// The text of the error that an action throws.
#pragma once

#include <gtest/gtest.h>
#include <string>

namespace gaspard {

template <class Error, class Action>
std::string message_of(Action&& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    ADD_FAILURE() << "nothing was thrown";
    return {};
}

} // namespace gaspard
