#pragma once

#include "panel_screen.h"

namespace lds::emulator {

/// Brightness tuning by the keys (§4.3.3), already started at the sensor: two targets, "Adjusting" after
/// each, then "Success" or "Failed". A long ENTER breaks it off.
class TuningScreen final : public PanelScreen {
public:
    using PanelScreen::PanelScreen;

    void gesture(Gesture gesture) override;
    void refresh() override;
    void draw(DisplayContent& content) const override;

private:
    enum class Step { Prompt, Adjusting, Success, Failed };
    void takePoint();
    void finish(Step step);

    int m_point = 1; ///< 1 or 2
    Step m_step = Step::Prompt;
    bool m_shownLongEnough = false; ///< "Adjusting", so that it can be read.
};

} // namespace lds::emulator
