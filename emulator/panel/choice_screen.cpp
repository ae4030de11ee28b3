#include "choice_screen.h"

#include "panel_text.h"

namespace lds::emulator {

ChoiceScreen::ChoiceScreen(PanelHost& host, const ScreenTitle& title, QList<Option> options,
                           std::optional<catalog::Value> current, Chosen chosen)
    : PanelScreen(host)
    , m_title(title)
    , m_options(std::move(options))
    , m_chosen(std::move(chosen))
{
    for (qsizetype index = 0; index < m_options.size(); ++index) {
        if (m_options[index].value == current)
            m_shown = index;
    }
}

void ChoiceScreen::gesture(Gesture gesture)
{
    m_refused = false;
    switch (gesture) {
    case Gesture::Up:
        move(-1);
        break;
    case Gesture::Down:
        move(1);
        break;
    case Gesture::Enter:
        take();
        break;
    case Gesture::HoldEnter:
        if (m_maySuspend)
            host().close();
        break;
    default:
        break;
    }
}

void ChoiceScreen::move(int by) { m_shown = (m_shown + by + m_options.size()) % m_options.size(); }

void ChoiceScreen::take()
{
    const auto value = m_options[m_shown].value;
    if (!value) {
        host().close();
    } else if (!m_chosen(*value)) {
        m_refused = true;
        later(messageMs, [this] { m_refused = false; });
    }
}

void ChoiceScreen::draw(DisplayContent& content) const
{
    content.screen = ScreenKind::Choice;
    drawTitle(content, m_title, host());
    content.body = host().text(m_options[m_shown].name);
    if (m_refused)
        content.note = host().text(words::error);
}

} // namespace lds::emulator
