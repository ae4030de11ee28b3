#include "panel_screen.h"

#include "panel_text.h"

namespace lds::emulator {

QString PanelHost::text(const char* english) const { return panelText(english, language()); }

void PanelScreen::later(int delayMs, std::function<void()> work)
{
    m_host.clock().after(delayMs, this, [this, run = std::move(work)] {
        if (!m_host.isOnTop(this))
            return;
        run();
        m_host.changed();
    });
}

} // namespace lds::emulator
