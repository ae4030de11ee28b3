#include "menu_screen.h"

#include "item_screens.h"

namespace lds::emulator {

MenuScreen::MenuScreen(PanelHost& host, int parent)
    : PanelScreen(host)
{
    for (const catalog::MenuEntry& entry : catalog::Catalog::hlG2().menu()) {
        if (entry.parent() == parent)
            m_entries.append(&entry);
    }
}

void MenuScreen::gesture(Gesture gesture)
{
    switch (gesture) {
    case Gesture::Up:
        move(-1);
        break;
    case Gesture::Down:
        move(1);
        break;
    case Gesture::Enter:
        openShown();
        break;
    case Gesture::HoldEnter:
        host().close();
        break;
    default:
        break;
    }
}

void MenuScreen::move(int by) { m_shown = (m_shown + by + m_entries.size()) % m_entries.size(); }

void MenuScreen::openShown()
{
    const catalog::MenuEntry& entry = *m_entries[m_shown];
    if (entry.items.empty())
        host().open(std::make_unique<MenuScreen>(host(), entry.number));
    else
        host().open(itemScreen(entry, host()));
}

void MenuScreen::draw(DisplayContent& content) const
{
    const catalog::MenuEntry& entry = *m_entries[m_shown];
    content.screen = ScreenKind::Menu;
    content.menuNumber = entry.number;
    content.hierarchyBars = entry.level();
    content.body = host().text(entry.name);
}

} // namespace lds::emulator
