#include "entry_screen.h"

#include "panel_text.h"

namespace lds::emulator {

void drawTitle(DisplayContent& content, const ScreenTitle& title, const PanelHost& host)
{
    content.menuNumber = title.menuNumber;
    content.hierarchyBars = title.bars;
    content.title = host.text(title.name);
}

EntryScreen::EntryScreen(PanelHost& host, const ScreenTitle& title, const QList<catalog::ItemId>& items,
                         std::function<void()> stored)
    : PanelScreen(host)
    , m_title(title)
    , m_digits(items, host.sensor())
    , m_stored(std::move(stored))
{}

void EntryScreen::gesture(Gesture gesture)
{
    m_refused = false;
    switch (gesture) {
    case Gesture::Up:
        m_digits.turn(1);
        break;
    case Gesture::Down:
        m_digits.turn(-1);
        break;
    case Gesture::Enter:
        moveOn();
        break;
    case Gesture::UpDown:
    case Gesture::HoldUpDown:
        m_digits.toFirst();
        break;
    case Gesture::HoldEnter:
        host().close();
        break;
    default:
        break;
    }
}

void EntryScreen::moveOn()
{
    if (m_digits.toNext())
        return;
    if (sensor().writeByKeys(m_digits.writes()).refusal) {
        m_refused = true;
        m_digits.toFirst();
        later(messageMs, [this] { m_refused = false; });
    } else if (m_stored) {
        m_stored();
    } else {
        host().close();
    }
}

void EntryScreen::draw(DisplayContent& content) const
{
    content.screen = ScreenKind::Entry;
    drawTitle(content, m_title, host());
    content.body = m_digits.text();
    content.edited = m_digits.edited();
    content.unit = m_digits.unit();
    if (m_refused)
        content.note = host().text(words::error);
}

} // namespace lds::emulator
