#pragma once

#include "entry_screen.h"
#include "panel_screen.h"

#include <optional>

namespace lds::emulator {

/// One of several: UP and DOWN go through them, ENTER takes the one that is shown, a long ENTER suspends.
class ChoiceScreen final : public PanelScreen {
public:
    struct Option {
        const char* name;                    ///< English; shown in the sensor's language.
        std::optional<catalog::Value> value; ///< Nothing: "Cancel", which only closes the screen.
    };
    /// Carries the choice out and closes the screen, or answers false: an error is shown then.
    using Chosen = std::function<bool(catalog::Value)>;

    ChoiceScreen(PanelHost& host, const ScreenTitle& title, QList<Option> options,
                 std::optional<catalog::Value> current, Chosen chosen);
    /// §3.6: the screens after the first start have nothing to go back to.
    void forbidSuspending() { m_maySuspend = false; }

    void gesture(Gesture gesture) override;
    void draw(DisplayContent& content) const override;

private:
    void move(int by);
    void take();

    ScreenTitle m_title;
    QList<Option> m_options;
    qsizetype m_shown = 0;
    Chosen m_chosen;
    bool m_maySuspend = true;
    bool m_refused = false;
};

} // namespace lds::emulator
