#include "tuning_screen.h"

#include "panel_text.h"

namespace lds::emulator {

using namespace catalog;

namespace {

constexpr int shortestAdjustingMs = 500;

} // namespace

void TuningScreen::gesture(Gesture gesture)
{
    if (m_step != Step::Prompt)
        return;
    if (gesture == Gesture::Enter) {
        takePoint();
    } else if (gesture == Gesture::HoldEnter) {
        sensor().interruptTuning();
        host().close();
    }
}

void TuningScreen::takePoint()
{
    if (sensor().takeTuningPoint(m_point).refusal) {
        sensor().interruptTuning();
        finish(Step::Failed);
        return;
    }
    m_step = Step::Adjusting;
    m_shownLongEnough = false;
    later(shortestAdjustingMs, [this] {
        m_shownLongEnough = true;
        refresh();
    });
}

void TuningScreen::refresh()
{
    const bool adjusting = m_step == Step::Adjusting;
    if (m_step != Step::Prompt && !adjusting)
        return;
    if (adjusting && (!m_shownLongEnough || sensor().tuning().isAdjusting()))
        return;
    switch (sensor().tuning().state()) {
    case TuningState::FirstPoint:
    case TuningState::SecondPoint:
        m_point = sensor().tuning().nextPoint();
        m_step = Step::Prompt;
        break;
    case TuningState::Success:
        finish(Step::Success);
        break;
    case TuningState::Failed:
        finish(Step::Failed);
        break;
    case TuningState::NotExecuted: // taken away from outside
        host().close();
        break;
    }
}

void TuningScreen::finish(Step step)
{
    m_step = step;
    later(messageMs, [this] { host().close(); });
}

void TuningScreen::draw(DisplayContent& content) const
{
    content.screen = m_step == Step::Prompt ? ScreenKind::Prompt : ScreenKind::Message;
    switch (m_step) {
    case Step::Prompt:
        content.title = host().text(m_point == 1 ? words::setFirstTarget : words::setSecondTarget);
        break;
    case Step::Adjusting:
        content.body = host().text(words::adjusting);
        break;
    case Step::Success:
        content.body = host().text(words::success);
        break;
    case Step::Failed:
        content.body = host().text(words::failed);
        break;
    }
}

} // namespace lds::emulator
