#pragma once

#include <optional>
#include <QtGlobal>

namespace lds::emulator {

/// Output delay timer selection (§4.5.1), codes as on the wire.
enum class OutputDelay : quint8 { Off = 0, OnDelay = 1, OffDelay = 2, OneShot = 3, Hold = 4 };

struct OutputDelaySettings {
    OutputDelay selection = OutputDelay::Off;
    qint64 durationNs = 1'000'000; ///< §4.5.2; means nothing to Off and Hold.
    bool operator==(const OutputDelaySettings&) const = default;
};

/// The delay between one judgment (HI, GO or LO) and its output (§4.5.1). Each output has its own, so
/// that two may be ON at once while an OFF is delayed.
///
/// Times are nanoseconds of one monotonic clock and never go back.
class OutputDelayTimer {
public:
    /// In effect at once, unless an output is being delayed or held: then when that output changes.
    void setSettings(const OutputDelaySettings& settings);
    /// The judgment from this moment on.
    void judge(bool judgment, qint64 nowNs)
    {
        if (judgment != m_judgment || m_dueNs)
            change(judgment, nowNs);
    }
    /// Lets time pass.
    void advance(qint64 nowNs);
    /// §4.11: OFF, whatever was under way; the judgment counts as OFF until it is told anew.
    void reset();

    bool output() const { return m_output; }

private:
    void change(bool judgment, qint64 nowNs);
    void rise(qint64 nowNs);
    void fall(qint64 nowNs);
    bool isBusy() const { return m_dueNs || (m_settings.selection == OutputDelay::Hold && m_output); }
    void adoptSettings();

    OutputDelaySettings m_settings; ///< In effect.
    OutputDelaySettings m_wanted;
    bool m_judgment = false;
    bool m_output = false;
    std::optional<qint64> m_dueNs; ///< When the delayed change comes.
};

} // namespace lds::emulator
