#pragma once

#include <QMetaType>
#include <QString>

namespace lds::emulator {

/// What the screen is; it decides where the lines of a DisplayContent stand.
enum class ScreenKind : quint8 {
    StartUp,
    Measurement,   ///< §2.2: the value in `body`, with the icons.
    ReceivedLight, ///< §4.1
    WindowValue,   ///< HIGH or LOW set value, looked at during measurement (§4.4.1).
    Menu,          ///< §2.2 "Setting screen", with menu number and bars.
    Choice,        ///< One of several.
    Entry,         ///< Digit by digit.
    Prompt,        ///< "Set Target - Push ENTER SW" over the measured value.
    Message,       ///< Words in the middle.
};

enum class Brightness : quint8 {
    Normal,
    Dim,
    Blink, ///< The moment in which a dim display shows that it lives (§4.8.2).
    Off,
};

enum class IndicatorState : quint8 { Off, Lit, Blinking };

/// The language of the display (§4.8.4), codes as on the wire.
enum class PanelLanguage : quint8 { English = 0, Japanese = 1, SimplifiedChinese = 2 };

/// The icons of the measurement display (§2.2).
struct DisplayIcons {
    bool laser = false;
    bool high = false;
    bool go = false;
    bool low = false;
    bool hold = false;
    bool zero = false;
    QString bank;     ///< "B1" … "B4"
    QString holdMode; ///< "P", "B", "PP", or nothing.
    bool operator==(const DisplayIcons&) const = default;
};

/// Everything that can be seen of a sensor from outside at one moment: its display and its two indicators.
/// A plain value that crosses threads. Texts are in the sensor's language.
struct DisplayContent {
    ScreenKind screen = ScreenKind::StartUp;
    int menuNumber = 0;    ///< 0: none is shown.
    int hierarchyBars = 0; ///< 1 … 3 with a menu number.
    QString title;         ///< Upper line.
    QString body;          ///< What it is about: the value, the choice, the digits, the words.
    QString unit;          ///< Behind the body.
    QString note;          ///< Lower line.
    int edited = -1;       ///< Index in `body` of the character that UP and DOWN change.
    DisplayIcons icons;    ///< On the measurement display.
    bool inverted = false; ///< Upside down (§4.8.3).
    Brightness brightness = Brightness::Normal;
    PanelLanguage language = PanelLanguage::English;
    IndicatorState laserIndicator = IndicatorState::Off; ///< Green, "laser radiation" (§2.2).
    IndicatorState alarmIndicator = IndicatorState::Off; ///< Orange.
    bool operator==(const DisplayContent&) const = default;
};

} // namespace lds::emulator

Q_DECLARE_METATYPE(lds::emulator::DisplayContent)
