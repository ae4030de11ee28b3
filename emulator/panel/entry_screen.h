#pragma once

#include "entry_digits.h"
#include "panel_screen.h"

namespace lds::emulator {

/// What stands over a screen of the setting mode (§2.2).
struct ScreenTitle {
    int menuNumber = 0; ///< 0: none.
    int bars = 0;
    const char* name = "";
};
void drawTitle(DisplayContent& content, const ScreenTitle& title, const PanelHost& host);

/// Entry digit by digit: UP and DOWN change the digit or the sign, ENTER moves on and stores at the last
/// one, UP and DOWN together go back to the first, a long ENTER suspends. A value that the sensor refuses
/// is answered with words, and the entry starts at its first digit again.
class EntryScreen final : public PanelScreen {
public:
    /// `stored` runs after the value was taken and has to close the screen; without it the screen closes
    /// itself.
    EntryScreen(PanelHost& host, const ScreenTitle& title, const QList<catalog::ItemId>& items,
                std::function<void()> stored = {});

    void gesture(Gesture gesture) override;
    void draw(DisplayContent& content) const override;

private:
    void moveOn();

    ScreenTitle m_title;
    EntryDigits m_digits;
    std::function<void()> m_stored;
    bool m_refused = false;
};

} // namespace lds::emulator
