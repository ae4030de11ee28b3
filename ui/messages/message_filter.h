#pragma once

#include "frame.h"

#include <QString>

namespace lds::ui {

/// Which messages a person wants to see.
struct MessageFilter {
    QString text; ///< Every word must occur in the sentence, the bytes or the sensor; any case.
    QString peer; ///< The sensor that `thisSensorOnly` means.
    bool thisSensorOnly = false;
    bool hidePolls = true; ///< Hundreds a second would drown everything else.
    bool failuresOnly = false;

    bool accepts(const ports::Frame& frame) const;
    friend bool operator==(const MessageFilter&, const MessageFilter&) = default;
};

/// A poll: reading nothing but the measurement and the state beside it (400011–400022), or its answer.
/// A poll that fails is no poll in this sense: failures are always worth seeing.
bool isPoll(const ports::Frame& frame);

/// Refused, unanswered, not understood, or a connection that ended with a reason.
bool isFailure(const ports::Frame& frame);

} // namespace lds::ui
