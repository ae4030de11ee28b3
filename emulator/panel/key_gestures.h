#pragma once

#include "emulator_clock.h"
#include "panel_key.h"

#include <array>
#include <functional>
#include <QObject>

namespace lds::emulator {

/// What a person did with the keys, as the manual's procedures name it.
enum class Gesture : quint8 {
    Up,
    Enter,
    Down,       ///< Pressed and let go within two seconds.
    HoldUp,     ///< UP held for two seconds: teaching (§4.9).
    HoldEnter,  ///< ENTER held for two seconds: setting mode in and out (§2.2).
    HoldDown,   ///< Means nothing.
    UpDown,     ///< Both, let go within two seconds: zero setting (§4.10), first digit.
    HoldUpDown, ///< Both held for two seconds: key lock (§4.12).
    DownEnter,  ///< Both: zero setting OFF (§4.10).
    UpEnter,    ///< Both: measured value resetting (§4.11).
};

/// Makes gestures of keys going down and up. A key alone, and UP with DOWN, mean one thing when let go soon
/// and another when held, so they are decided at the release or after two seconds; the other pairs act at
/// once. After a gesture nothing more happens until every key is up.
class KeyGestures : public QObject {
public:
    static constexpr int holdMs = 2000;

    KeyGestures(EmulatorClock& clock, std::function<void(Gesture)> done, QObject* parent = nullptr);

    void press(Key key);
    void release(Key key);
    /// What is held now means nothing any more.
    void swallow();
    bool isHeld(Key key) const { return m_held[std::size_t(key)]; }
    bool anyHeld() const { return m_held[0] || m_held[1] || m_held[2]; }

private:
    void finish(Gesture gesture);
    void waitFor(Gesture gesture);
    void stopWaiting();

    EmulatorClock& m_clock;
    std::function<void(Gesture)> m_done;
    std::array<bool, keyCount> m_held{};
    std::array<bool, keyCount> m_together{}; ///< Down since all were up.
    bool m_swallowed = false;
    EmulatorClock::TimerId m_timer = 0;
};

} // namespace lds::emulator
