#pragma once

#include "sensor_session.h"

#include <optional>
#include <QString>

namespace lds::ui {

enum class Judgment { None, High, Go, Low };

/// What the readout shows, worked out and in words; painting it decides nothing any more.
struct ReadoutState {
    QString value;         ///< "+1.2345", "----", "+OVER", "ALARM", "E100**"; empty when there is none.
    bool isNumber = false; ///< A unit belongs beside it.
    bool isLive = false;   ///< False: dimmed; it is the last one received.
    bool isFrozen = false; ///< An alarm with the digital output on Hold: not a measurement (§4.7.2).
    Judgment judgment = Judgment::None;
    bool laser = false;
    bool hold = false;
    bool zero = false;
    bool keyLock = false;
    int bank = 0;                 ///< 1 … 4; 0 while not known.
    QString holdModeLetter;       ///< P, B, PP; empty in normal mode (§2.2).
    std::optional<int> intensity; ///< 0 … 1023
    QString notice;               ///< Why the value is not a good one; empty when all is well.
    QString pace;                 ///< "100 per s · 0 lost"
};

/// nullptr: nothing connected.
ReadoutState readoutState(const sensor::SensorSession* session);
/// Decimals of the display digit's code (§5.2.4, 400111: 0 is four decimals, 4 is none).
int displayDecimals(catalog::Value displayDigit);
/// "+1.2345 mm, GO, laser on, bank 1"
QString spokenText(const ReadoutState& state);

} // namespace lds::ui
